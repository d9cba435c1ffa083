#include "run/run_files.hpp"

#include <filesystem>

namespace blocks::run {
namespace {

/// An older file of that name is kept as .bak.
std::string put_aside(const std::string& path) {
  std::error_code ignored;  // what cannot be moved shows when the new file is opened
  if (std::filesystem::is_regular_file(path, ignored))
    std::filesystem::rename(path, path + ".bak", ignored);
  return path;
}

}  // namespace

RunFiles::RunFiles(const std::string& name, const output::RunIdentity& identity)
    : name_(name), identity_(identity), listing_(put_aside(name + ".out"), false),
      results_(std::make_unique<output::ResultsWriter>(name + ".vtkhdf", identity)) {
  listing_.deck_echo(identity);
}

RunFiles RunFiles::behind(const std::string& name, const output::RunIdentity& identity,
                          const output::CheckpointInfo& from) {
  const std::string results = name + ".vtkhdf", listing = name + ".out";
  if (from.results != results || from.results_run.empty() ||
      output::ResultsWriter::run_id_of(results) != from.results_run)
    return {name, identity};  // those beside us, if any, belong to another run
  std::error_code ignored;    // what is wrong shows when the listing is opened
  if (std::filesystem::file_size(listing, ignored) >
      static_cast<std::uintmax_t>(from.listing_bytes))
    std::filesystem::resize_file(
        listing, static_cast<std::uintmax_t>(from.listing_bytes), ignored);
  return {name, identity, from.results_frames};
}

RunFiles::RunFiles(std::string name, const output::RunIdentity& identity,
                   long kept_frames)
    : name_(std::move(name)), identity_(identity), listing_(name_ + ".out", true),
      results_(std::make_unique<output::ResultsWriter>(
          output::ResultsWriter::reopen(results_path(), kept_frames))) {
  listing_.deck_echo(identity);
}

void RunFiles::table(const Model& model) {
  if (model.steps == tabled_step_)
    return;
  tabled_step_ = model.steps;
  listing_.table(model);
}

void RunFiles::checkpoint(const Model& model) {
  output::write_checkpoint(checkpoint_path(), model,
                           {identity_.deck_file, identity_.deck_text, results_path(),
                            results_->run_id(), results_->frames(), listing_.size(),
                            identity_.version});
}

void RunFiles::close(const Model& model, output::RunReport report) {
  frame(model);
  table(model);
  listing_.closing(model);
  if (report.status != "unsound")  // the last good one stays
    checkpoint(model);
  report.identity = identity_;
  report.frames = results_->frames();
  output::write_summary(summary_path(), model, report);
}

}  // namespace blocks::run
