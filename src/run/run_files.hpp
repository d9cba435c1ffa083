// The files of one run, written together: listing, results, checkpoint, summary.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "output/checkpoint.hpp"
#include "output/listing.hpp"
#include "output/results.hpp"
#include "output/summary.hpp"

namespace blocks::run {

class RunFiles {
 public:
  /// Creates NAME.out and NAME.vtkhdf. The older files of that name get the ending
  /// .bak; where files of another deck have that name already, .bak2 and so on. Throws
  /// output::FileError.
  RunFiles(const std::string& name, const output::RunIdentity& identity);
  /// Continues NAME.out and NAME.vtkhdf behind a checkpoint, whatever was written later
  /// cut off; new files where those beside us belong to another run. Throws FileError,
  /// and changes nothing, where they lack what was written before, or where NAME is
  /// that of the checkpoint and they are not there.
  static RunFiles behind(const std::string& name, const output::RunIdentity& identity,
                         const output::CheckpointInfo& from,
                         const std::string& checkpoint);
  /// The same for the deck that was stopped there: what its end added is cut off too,
  /// as if it had never stopped.
  static RunFiles resumed(const std::string& name, const output::RunIdentity& identity,
                          const output::CheckpointInfo& from,
                          const std::string& checkpoint);

  void input_echo(const Model& model) { listing_.input_echo(model); }
  void dump(const Model& model) { listing_.dump(model); }
  void message(const std::string& line) { listing_.message(line); }
  void frame(const Model& model);
  void table(const Model& model);
  void checkpoint(const Model& model, const output::Progress& progress) {
    good_checkpoint(model, here(progress));
  }
  /// A state kept in memory since progress, which here() has told.
  void good_checkpoint(const Model& model, const output::Progress& progress) {
    checkpoint_at(model, progress, {progress.frames, progress.listing_bytes});
  }
  /// With how far results and listing are by now.
  output::Progress here(output::Progress progress);
  /// Last frame, closing table, checkpoint, summary. A run that goes on from there
  /// begins before all of that.
  void close(const Model& model, output::RunReport report,
             const output::Progress& progress);

  /// What was put aside, in words, if it belongs to another deck; else empty.
  const std::string& put_aside() const { return put_aside_; }

  std::string checkpoint_path() const { return name_ + ".ckpt.h5"; }
  std::string summary_path() const { return name_ + ".summary.json"; }
  std::string results_path() const { return name_ + ".vtkhdf"; }

 private:
  RunFiles(std::string name, const output::RunIdentity& identity, long kept_frames,
           long kept_bytes);
  std::string step_aside(const std::string& path);
  static bool continues(const std::string& name, const output::CheckpointInfo& from,
                        long listing_bytes, const std::string& checkpoint);
  /// What a run behind the checkpoint leaves of results and listing.
  struct Kept {
    long frames, bytes;
  };
  void checkpoint_at(const Model& model, const output::Progress& progress, Kept kept);

  std::string name_;
  output::RunIdentity identity_;
  /// Files that have stepped aside. They come back where no frame is written: until
  /// then the older results keep their name, too.
  struct Older {
    std::string ending;
    std::vector<std::string> paths;
    explicit Older(std::string of_theirs = {}) : ending(std::move(of_theirs)) {}
    Older(Older&&) = default;
    ~Older();
  };
  Older older_;
  std::string put_aside_;
  std::unique_ptr<output::ResultsWriter> results_;
  output::Listing listing_;
  long tabled_step_ = -1;
};

}  // namespace blocks::run
