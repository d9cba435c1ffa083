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

RunFiles::RunFiles(const std::string& name, const output::RunIdentity& identity,
                   const output::CheckpointInfo& from)
    : name_(name), identity_(identity),
      listing_(from.results == results_path() ? name + ".out"
                                              : put_aside(name + ".out"),
               from.results == results_path()) {
  if (from.results == results_path() && std::filesystem::exists(results_path()))
    results_ = std::make_unique<output::ResultsWriter>(
        output::ResultsWriter::reopen(results_path(), from.results_frames));
  else
    results_ = std::make_unique<output::ResultsWriter>(results_path(), identity);
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
                            results_->frames(), identity_.version});
}

void RunFiles::close(const Model& model, output::RunReport report) {
  frame(model);
  table(model);
  listing_.closing(model);
  checkpoint(model);
  report.identity = identity_;
  report.frames = results_->frames();
  output::write_summary(summary_path(), model, report);
}

}  // namespace blocks::run
