// The files of one run, written together: listing, results, checkpoint, summary.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/checkpoint.hpp"
#include "output/listing.hpp"
#include "output/results.hpp"
#include "output/summary.hpp"

namespace blocks::run {

class RunFiles {
 public:
  /// Creates NAME.out and NAME.vtkhdf (older ones become .bak). Throws
  /// output::FileError.
  RunFiles(const std::string& name, const output::RunIdentity& identity);
  /// Continues NAME.out and NAME.vtkhdf behind a checkpoint, whatever was written later
  /// cut off; new files where those beside us belong to another run.
  static RunFiles behind(const std::string& name, const output::RunIdentity& identity,
                         const output::CheckpointInfo& from);

  void input_echo(const Model& model) { listing_.input_echo(model); }
  void dump(const Model& model) { listing_.dump(model); }
  void message(const std::string& line) { listing_.message(line); }
  void frame(const Model& model) { results_->write(model); }
  void table(const Model& model);
  void checkpoint(const Model& model);
  /// Last frame, closing table, checkpoint, summary.
  void close(const Model& model, output::RunReport report);

  std::string checkpoint_path() const { return name_ + ".ckpt.h5"; }
  std::string summary_path() const { return name_ + ".summary.json"; }
  std::string results_path() const { return name_ + ".vtkhdf"; }

 private:
  RunFiles(std::string name, const output::RunIdentity& identity, long kept_frames);

  std::string name_;
  output::RunIdentity identity_;
  output::Listing listing_;
  std::unique_ptr<output::ResultsWriter> results_;
  long tabled_step_ = -1;
};

}  // namespace blocks::run
