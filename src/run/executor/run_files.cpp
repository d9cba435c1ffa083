#include "run/executor/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "files/file_tools.hpp"
#include "files/name_lock.hpp"
#include "output/results/results_mark.hpp"
#include "run/executor/saved_state.hpp"
#include "run/support/shell_word.hpp"

namespace blocks::run {
namespace {

bool exists(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

/// The files of a run. If they are renamed, all of them get the same ending.
constexpr const char* endings[] = {".out", ".vtkhdf", ".ckpt.h5", ".ckpt.h5.prev",
                                   ".summary.json"};

/// Whether the files with this ending may be overwritten: there are none, or they
/// belong to a run of this deck. A file that another program may have written is kept,
/// and so are files of a finished run (with a summary) if the present files have no
/// summary.
bool may_overwrite(const std::string& name, const std::string& ending,
                   const output::RunIdentity& identity) {
  const std::string results = name + ".vtkhdf" + ending,
                    listing = name + ".out" + ending, summary = name + ".summary.json";
  if (!exists(results))
    return std::none_of(std::begin(endings), std::end(endings), [&](const char* kind) {
      return exists(name + kind + ending);  // their deck is unknown
    });
  if (exists(listing) && !files::has_text(listing, 0, "BLOCKS "))
    return false;
  if (exists(summary + ending) && !exists(summary))
    return false;
  const auto deck = output::ResultsWriter::identity_of(results);
  return deck && deck->same_deck(identity);
}

/// The first of .bak, .bak2, ... whose files may be overwritten.
std::string free_ending(const std::string& name, const output::RunIdentity& identity) {
  for (int number = 1;; ++number)
    if (std::string ending = number == 1 ? ".bak" : fmt::format(".bak{}", number);
        may_overwrite(name, ending, identity))
      return ending;
}

/// Removes the temporary files that killed runs have left, which may be large. Files
/// that another program may have written stay. The name is locked.
void remove_leftovers(const std::string& name) {
  for (const std::string& file : {name + ".vtkhdf", name + ".ckpt.h5"})
    for (int number = 1;; ++number) {
      const std::string path =
          file + (number == 1 ? ".tmp" : fmt::format(".tmp{}", number));
      std::error_code ignored;
      if (!std::filesystem::exists(std::filesystem::symlink_status(path, ignored)))
        break;
      // The text at the head of a checkpoint is written last.
      if (files::has_text(path, 0, "BLOCKS ") ||
          files::has_text(path, 512, "\x89HDF\r\n\x1a\n"))
        std::filesystem::remove(path, ignored);
    }
}

/// Throws FileError if a program without NameLock, such as an earlier version, is
/// writing the results.
void expect_idle(const std::string& name) {
  const std::string results = name + ".vtkhdf";
  if (output::is_being_written(results) || output::is_being_written(results + ".tmp"))
    throw files::FileError(fmt::format(
        "cannot write {}: another run is writing it; use -o NAME for other files",
        results));
}

/// Returns the name. Throws FileError before the run if one of its files cannot be
/// replaced or is being written.
const std::string& replaceable(const std::string& name) {
  expect_idle(name);
  for (const char* ending : endings)
    files::expect_replaceable(name + ending);
  remove_leftovers(name);
  return name;
}

[[noreturn]] void refuse_to_continue(const std::string& path,
                                     const std::string& checkpoint,
                                     const std::string& reason) {
  throw files::FileError(
      fmt::format("cannot continue {}: {}; use --restart {} -o NAME for new files",
                  path, reason, shell_word(checkpoint)));
}

/// Throws FileError unless the listing holds everything written before the checkpoint.
void expect_listing(const std::string& path, long bytes,
                    const std::string& checkpoint) {
  std::error_code missing;
  const auto size = std::filesystem::file_size(path, missing);
  if (missing)
    refuse_to_continue(path, checkpoint, "it does not exist");
  if (size < static_cast<std::uintmax_t>(bytes))
    refuse_to_continue(
        path, checkpoint,
        fmt::format("it has {} bytes, but {} were written before the checkpoint", size,
                    bytes));
}

/// Creates the listing, never through a link. Returns the path.
std::string created(const std::string& path) {
  files::create_new_file(path);
  return path;
}

/// Truncates the listing to its length at the checkpoint. Returns the path.
std::string cut(const std::string& path, long bytes) {
  files::expect_replaceable(path);
  std::error_code ignored;  // opening the listing reports errors
  std::filesystem::resize_file(path, static_cast<std::uintmax_t>(bytes), ignored);
  return path;
}

/// The warning about older results of another deck, or of this deck before a change;
/// otherwise empty.
std::string foreign(const std::string& results, const output::RunIdentity& identity,
                    const std::string& ending) {
  const auto other = output::ResultsWriter::identity_of(results);
  if (!other || other->same_deck(identity))
    return {};
  const bool changed = other->deck_name() == identity.deck_name();
  return fmt::format(
      "{} had results of {}: the old files are kept with the extension {}", results,
      changed ? "this deck with other text, options or seed"
              : "another deck, " + other->deck_name(),
      ending);
}

/// The identity of new results that continue those of the checkpoint.
output::RunIdentity continuation(output::RunIdentity identity,
                                 const output::CheckpointInfo& from) {
  identity.continues_run = from.results_run;
  return identity;
}

}  // namespace

RunFiles::RunFiles(const std::string& name, const output::RunIdentity& identity)
    : name_(replaceable(name)), identity_(identity),
      older_(free_ending(name, identity)),
      put_aside_(foreign(results_path(), identity, older_.ending)),
      results_(std::make_unique<output::ResultsWriter>(results_path(), identity,
                                                       older_.ending)),
      listing_(created(step_aside(name + ".out")), false) {
  for (const std::string& path :
       {checkpoint_path(), checkpoint_path() + ".prev", summary_path()})
    step_aside(path);
  listing_.deck_echo(identity);
}

/// Renames an older file to its new ending.
std::string RunFiles::step_aside(const std::string& path) {
  std::error_code ignored;  // opening the new file reports errors
  if (std::filesystem::is_regular_file(path, ignored)) {
    files::move_file(path, path + older_.ending);
    older_.paths.push_back(path);
  }
  return path;
}

RunFiles::Older::~Older() {
  std::error_code ignored;  // the run has already failed
  for (const std::string& path : paths)
    std::filesystem::rename(path + ending, path, ignored);
}

void RunFiles::frame(const Model& model) {
  results_->write(model);
  older_.paths.clear();
}

RunFiles RunFiles::behind(const std::string& name, const output::RunIdentity& identity,
                          const output::CheckpointInfo& from,
                          const std::string& checkpoint) {
  if (!continues(name, from, from.listing_bytes, checkpoint))
    return {name, continuation(identity, from)};
  RunFiles files(name, identity, {from.results_frames, from.listing_bytes},
                 from.progress.samples);
  files.listing_.deck_echo(identity);
  return files;
}

RunFiles RunFiles::resumed(const std::string& name, const output::RunIdentity& identity,
                           const output::CheckpointInfo& from,
                           const std::string& checkpoint) {
  if (!continues(name, from, from.progress.listing_bytes, checkpoint))
    return {name, continuation(identity, from)};
  RunFiles files(name, identity, {from.progress.frames, from.progress.listing_bytes},
                 from.progress.samples);
  files.tabled_step_ = from.progress.tabled_step;
  files.resumed_ = true;
  return files;
}

/// Whether the results and the listing of this name belong to the checkpoint's run.
/// Throws FileError if they do but lack data.
bool RunFiles::continues(const std::string& name, const output::CheckpointInfo& from,
                         long listing_bytes, const std::string& checkpoint) {
  const std::string results = name + ".vtkhdf";
  if (!from.results_run.empty() &&
      output::ResultsWriter::run_id_of(results) == from.results_run) {
    expect_idle(name);
    remove_leftovers(name);
    expect_listing(name + ".out", listing_bytes, checkpoint);
    return true;
  }
  // The checkpoint alone suffices. Existing results of its name must not be replaced.
  std::error_code ignored;
  for (const char* ending : {".ckpt.h5", ".ckpt.h5.prev"})
    if (exists(results) &&
        std::filesystem::equivalent(checkpoint, name + ending, ignored))
      refuse_to_continue(results, checkpoint,
                         "another run wrote it, not that of the checkpoint");
  return false;  // existing files, if any, belong to another run
}

RunFiles::RunFiles(std::string name, const output::RunIdentity& identity, Kept kept,
                   long kept_samples)
    : name_(std::move(name)), identity_(identity),
      results_(std::make_unique<output::ResultsWriter>(
          output::ResultsWriter::reopen(results_path(), kept.frames, kept_samples))),
      listing_(cut(name_ + ".out", kept.bytes), true) {}

void RunFiles::table(const Model& model) {
  if (model.steps == tabled_step_)
    return;
  tabled_step_ = model.steps;
  listing_.table(model);
}

output::Progress RunFiles::here(output::Progress progress) {
  progress.frames = results_->frames();
  progress.samples = results_->samples();
  progress.listing_bytes = listing_.size();
  progress.tabled_step = tabled_step_;
  return progress;
}

std::string RunFiles::save(const std::string& path, const Model& model,
                           const output::Progress& progress) {
  const files::NameLock lock(path.substr(0, path.size() - checkpoint_ending.size()),
                             path);
  const std::string warning = put_aside_unless_own(path, identity_);
  const output::Progress now = here(progress);
  checkpoint_at(path, model, now, {now.frames, now.listing_bytes});
  return warning;
}

std::string RunFiles::keep_state(const std::string& ending, const std::string& what,
                                 const Model& before, const Model& after,
                                 const output::Progress& progress) {
  const std::string name = name_ + "." + ending;
  const files::NameLock lock(name, name + ".vtkhdf");
  const bool is_own = !kept_.insert(ending).second || resumed_;
  if (is_own && may_overwrite(name, "", identity_))  // those of an earlier trial
    for (const char* kind : endings) {
      std::error_code ignored;  // a file that stays is put aside
      std::filesystem::remove(name + kind, ignored);
    }
  RunFiles files(name, identity_);
  files.results().include_unbalanced();
  files.message(what);
  files.input_echo(after);
  files.frame(before);
  files.close(after, {}, progress);
  return files.put_aside();
}

std::string RunFiles::move_state_aside(const std::string& ending) {
  const std::string name = name_ + "." + ending, results = name + ".vtkhdf";
  if (!exists(results))
    return {};
  const files::NameLock lock(name, results);
  const std::string older = free_ending(name, identity_);
  const std::string warning = foreign(results, identity_, older);
  for (const char* kind : endings)
    if (exists(name + kind))
      files::move_file(name + kind, name + kind + older);
  return warning;
}

void RunFiles::checkpoint_at(const std::string& path, const Model& model,
                             const output::Progress& progress, Kept kept) {
  // The files that a checkpoint refers to must be on disk before it is.
  results_->flush_history();
  for (const std::string& file : {results_path(), name_ + ".out"})
    if (std::filesystem::is_regular_file(file))
      files::sync_file(file, file);
  output::write_checkpoint(path, model,
                           {identity_.deck_file, identity_.deck_text,
                            identity_.overrides, results_path(), results_->run_id(),
                            kept.frames, kept.bytes, identity_.version, progress});
}

void RunFiles::close(const Model& model, output::RunReport report,
                     const output::Progress& progress, bool changed) {
  const output::Progress stopped = here(progress);
  results_->write(model, changed);
  older_.paths.clear();
  results_->flush_history();
  table(model);
  listing_.closing(model);
  if (report.status != "unsound")  // keep the last good checkpoint
    checkpoint_at(checkpoint_path(), model, stopped,
                  {results_->frames(), listing_.size()});
  report.identity = identity_;
  report.frames = results_->frames();
  output::write_summary(summary_path(), model, report);
}

}  // namespace blocks::run
