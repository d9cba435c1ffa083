#include "run/run.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "dynamics/preparation/time_step.hpp"
#include "run/built_deck.hpp"
#include "run/deck_run.hpp"
#include "run/reports/check_report.hpp"
#include "run/support/interrupt.hpp"

namespace blocks::run {
namespace {

void tell(const Job& job) {
  // fmt::print would throw if nothing reads standard error, and end the run.
  if (job.options.tell)
    job.options.tell(job.diagnostics);
  else
    std::fputs(job.diagnostics.format_all().c_str(), stderr);
}

std::vector<std::string> warnings_of(const deck::Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const deck::Diagnostic& diagnostic : diagnostics.all())
    if (diagnostic.severity == deck::Severity::warning)
      result.push_back(fmt::format("{}:{}:{}: {}: {}", diagnostics.file(),
                                   diagnostic.where.line, diagnostic.where.column,
                                   diagnostic.card, diagnostic.message));
  return result;
}

/// Returns whether a file of the run would replace the deck, and says so.
bool overwrites_deck(const Job& job) {
  for (const char* ending : {".out", ".vtkhdf", ".ckpt.h5", ".summary.json"}) {
    std::error_code absent;
    if (std::filesystem::equivalent(job.options.deck, job.name + ending, absent)) {
      fmt::print(stderr,
                 "blocks: error: the run would overwrite its deck {}\n  hint: choose "
                 "another name with -o NAME\n",
                 job.options.deck);
      return true;
    }
  }
  return false;
}

CheckedDeck checked_deck(Job& job) {
  CheckedDeck checked;
  checked.file = job.diagnostics.file();
  std::optional<BuiltDeck> built = build(job);
  tell(job);
  if (!built) {
    checked.code = job.fault;
    return checked;
  }
  checked.model = std::move(built->start());
  checked.certificate = built->builder.certificate;
  checked.notes = std::move(built->notes);
  if (checked.model.blocks.count_present() > 0)
    checked.time_step = dynamics::choose_time_step(checked.model).dt;
  return checked;
}

}  // namespace

int run_deck(const RunOptions& options) {
  Job job(options);
  if (overwrites_deck(job))
    return usage_error;
  catch_interrupts();
  std::optional<EndAtOnce> at_once;
  if (options.ends_process)
    at_once.emplace(nothing_written, interrupted);
  std::optional<BuiltDeck> built = build(job);
  tell(job);
  if (!built)
    return job.fault;
  const Model& start = built->start();
  if (options.verbose) {
    std::fputs(check_report(job.diagnostics.file(), start, built->builder.certificate)
                   .c_str(),
               stderr);
    for (const std::string& note : built->notes)
      std::fputs((note + '\n').c_str(), stderr);
  }
  if (options.until && job.loads() && start.time >= *options.until) {
    fmt::print(stderr,
               "blocks: error: --until {} is not later than the time of {}, {:g}\n",
               *options.until, job.checkpoint(), start.time);
    return usage_error;
  }
  if (options.at_start && !job.loads())
    options.at_start(start, built->builder.certificate);
  at_once.reset();
  Console console(!options.json, options.quiet);
  console.give_warnings_to(options.warn);
  return run_built(job, *std::move(built), console, warnings_of(job.diagnostics));
}

CheckedDeck build_checked(const RunOptions& options) {
  Job job(options);
  return checked_deck(job);
}

int check_deck(const RunOptions& options) {
  Job job(options);
  catch_interrupts();
  const EndAtOnce at_once(nothing_written, interrupted);
  const auto checked = checked_deck(job);
  if (checked.code != done)
    return checked.code;
  if (!options.quiet) {
    auto certificate = checked.certificate;
    if (certificate && certificate->blocks < checked.model.blocks.size()) {
      // A resumed run proves new blocks when it moves them.
      certificate = std::make_shared<const AssemblyCertificate>(
          certify_assembly(checked.model.blocks, certificate->moved, *certificate));
    }
    fmt::print("{}", check_report(checked.file, checked.model, certificate));
    for (const std::string& note : checked.notes)
      fmt::print("{}\n", note);
  }
  return done;
}

}  // namespace blocks::run
