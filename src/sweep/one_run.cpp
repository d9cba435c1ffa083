#include "sweep/one_run.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <new>

#include "files/file_tools.hpp"
#include "run/run.hpp"
#include "run/support/interrupt.hpp"
#include "study/scene.hpp"
#include "sweep/layer_measures.hpp"
#include "sweep/outcome.hpp"
#include "sweep/run_log.hpp"
#include "sweep/study_outcome.hpp"

namespace blocks::sweep {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

run::RunOptions options_of(const Plan& plan, const Variation& run) {
  run::RunOptions options;
  options.deck = plan.deck;
  options.seed = run.seed;
  options.overrides = overrides_of(run);
  options.until = plan.until;
  options.audit_every = plan.audit_every;
  options.threads = 1;
  options.quiet = true;
  return options;
}

/// The files of a run that the program has not finished.
class RunFolder {
 public:
  RunFolder(const std::string& folder, const std::string& name)
      : name_(folder + '/' + name) {}

  const std::string& name() const { return name_; }
  /// The checkpoint from which the run goes on; empty if there is none.
  std::string checkpoint() const {
    for (const char* ending : {".ckpt.h5", ".ckpt.h5.prev"})
      if (fs::exists(name_ + ending))
        return name_ + ending;
    return {};
  }
  /// Removes what a run without a checkpoint has written. The next run keeps other
  /// files as .bak.
  void clear() const {
    for (const char* ending : {".out", ".vtkhdf"}) {
      files::expect_replaceable(name_ + ending);
      if (files::has_text(name_ + ending, 0, "BLOCKS "))
        fs::remove(name_ + ending);
    }
    if (summary().contains("state_hash"))
      fs::remove(summary_path());
  }
  /// Keeps the measures of the blocks at the start. A run that goes on from a
  /// checkpoint does not make them again.
  void write_layers(const Json& layers) const {
    if (!read_json(layers_path()).contains(layers_mark))
      files::set_aside(layers_path());
    files::replace_file(layers_path(), layers.dump() + '\n');
  }
  Json layers() const { return read_json(layers_path()); }
  Json summary() const { return read_json(summary_path()); }

 private:
  /// A key that measures of blocks have.
  static constexpr const char* layers_mark = "angles_redrawn";

  /// Returns what a regular file has; null if it is missing or damaged.
  static Json read_json(const std::string& path) {
    if (!files::has_text(path, 0, "{"))
      return {};
    std::ifstream in(path, std::ios::binary);
    const Json json = Json::parse(in, nullptr, false);
    return json.is_object() ? json : Json();
  }
  std::string layers_path() const { return name_ + ".layers.json"; }
  std::string summary_path() const { return name_ + ".summary.json"; }

  std::string name_;
};

/// Runs the deck, or goes on with it. Returns its exit code.
int run_the_deck(const Plan& plan, const Variation& run, const RunFolder& files,
                 const RunChoice& choice) {
  run::RunOptions options = options_of(plan, run);
  options.output = files.name();
  options.time_limit = choice.time_limit;
  options.checkpoint_every = choice.checkpoint_every;
  if (const std::string checkpoint = files.checkpoint(); !checkpoint.empty()) {
    options.restart = checkpoint;
    try {
      return run::run_deck(options);
    } catch (const files::FileError& fault) {
      fmt::print(stderr, "blocks: warning: {}; the run begins again\n", fault.what());
    }
    options.restart.reset();  // the run keeps the files that are there as .bak
  } else {
    files.clear();
  }
  options.at_start = [&](const Model& model, const SharedCertificate& certificate) {
    files.write_layers(to_json(measure_layers(model, certificate)));
  };
  return run::run_deck(options);
}

/// Calls `work`, which returns an exit code. Prints what it throws, and keeps it in
/// `message`, because a log on a full disk is empty.
template <class Work> int with_faults_told(std::string& message, Work&& work) {
  const auto tell = [&](const char* kind, const std::string& what, int code) {
    fmt::print(stderr, "blocks: {}: {}\n", kind, what);
    message = what;
    return code;
  };
  try {
    return work();
  } catch (const files::FileError& fault) {
    return tell("error", fault.what(), run::file_error);
  } catch (const std::bad_alloc&) {
    return tell("error", "there is not enough memory for this problem",
                run::internal_error);
  } catch (const std::exception& fault) {
    return tell("internal error", fault.what(), run::internal_error);
  }
}

int run(const std::string& run_folder, const Plan& plan, const Variation& run,
        const RunChoice& choice, Json& measured) {
  const RunFolder files(run_folder, plan.name);
  const int code = run_the_deck(plan, run, files, choice);
  if (const Json layers = files.layers(); layers.is_object())
    measured["layers"] = layers;
  if (Json safety = safety_outcome(files.summary()); !safety.is_null())
    measured["factor_of_safety"] = std::move(safety);
  return code;
}

int check(const Plan& plan, const Variation& run, Json& measured) {
  const auto checked = run::build_checked(options_of(plan, run));
  if (checked.code == run::done)
    measured["layers"] = to_json(measure_layers(checked.model, checked.certificate));
  return checked.code;
}

int study(const Plan& plan, const Variation& run, Json& measured) {
  try {
    measured["study"] = study_outcome(scene_of(run), static_cast<int>(run.seed.value()),
                                      study_seed, plan.variants);
  } catch (const study::UnfitBlock& fault) {
    fmt::print(stderr, "blocks: error: {}\n", fault.what());
    return run::deck_error;
  }
  return run::done;
}

int run_in(const std::string& run_folder, const Plan& plan, const Variation& variation,
           const RunChoice& choice, Json& measured) {
  switch (plan.kind) {
  case Kind::run:
    return run(run_folder, plan, variation, choice, measured);
  case Kind::check:
    return check(plan, variation, measured);
  case Kind::study:
    return study(plan, variation, measured);
  }
  return run::internal_error;
}

}  // namespace

RunEnd run_once(const std::string& folder, const Plan& plan, std::size_t id,
                const RunChoice& choice) {
  using What = RunEnd::What;
  const std::string place = run_folder(folder, id);
  const Variation& run = plan.runs.at(id - 1);
  Outcome outcome;
  try {
    RunLog log(place);
    if (!log.lock() || has_outcome(place))
      return {What::elsewhere};
    log.take_streams();
    fmt::print(stderr, "blocks sweep: run {}{}{}\n", id,
               words_of(run).empty() ? "" : ": ", words_of(run));
    outcome.code = with_faults_told(outcome.message, [&] {
      return run_in(place, plan, run, choice, outcome.measured);
    });
    if (outcome.code == run::time_limit)
      outcome.message = fmt::format("stopped after {:g} s", choice.time_limit);
    else if (outcome.code != run::done && outcome.message.empty())
      outcome.message = log.fault();
    if (!is_final(outcome.code))
      return {outcome.code == run::interrupted ? What::interrupted : What::not_written,
              outcome.code, outcome.message};
    outcome.status = status_of(outcome.code);
    write_outcome(place, outcome);
  } catch (const std::exception& fault) {  // of the log, too
    return {What::not_written, run::file_error, fault.what()};
  }
  return {What::finished, outcome.code, outcome.message};
}

void write_crash(const std::string& folder, std::size_t id, int signal) {
  const int code = 128 + signal;
  write_outcome(run_folder(folder, id),
                {code, status_of(code), "the program crashed; log.txt may say where"});
}

}  // namespace blocks::sweep
