// The output files of one run: listing, results, checkpoint and summary.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "output/checkpoint/checkpoint.hpp"
#include "output/listing/listing.hpp"
#include "output/results/results.hpp"
#include "output/summary.hpp"

namespace blocks::run {

class RunFiles {
 public:
  /// Creates NAME.out and NAME.vtkhdf. Older files with these names get the ending
  /// .bak, or .bak2 and so on if files of another deck already have it. Throws
  /// files::FileError.
  RunFiles(const std::string& name, const output::RunIdentity& identity);
  /// Continues NAME.out and NAME.vtkhdf after a checkpoint and discards what was
  /// written later. If existing files of that name belong to another run, it creates
  /// new ones.
  ///
  /// Throws FileError and changes nothing if the files lack data written before the
  /// checkpoint. It also does so if the checkpoint is that of NAME but the results are
  /// of another run. Without results, the checkpoint suffices: it creates new files.
  static RunFiles behind(const std::string& name, const output::RunIdentity& identity,
                         const output::CheckpointInfo& from,
                         const std::string& checkpoint);
  /// The same for a deck that was stopped at the checkpoint. It also discards what the
  /// end of that run added, as if the run had never stopped.
  static RunFiles resumed(const std::string& name, const output::RunIdentity& identity,
                          const output::CheckpointInfo& from,
                          const std::string& checkpoint);

  void input_echo(const Model& model) { listing_.input_echo(model); }
  void dump(const Model& model) { listing_.dump(model); }
  void message(const std::string& line) { listing_.message(line); }
  void frame(const Model& model);
  void table(const Model& model);
  /// The results, for the recorder of histories.
  output::ResultsWriter& results() { return *results_; }
  void checkpoint(const Model& model, const output::Progress& progress) {
    good_checkpoint(model, here(progress));
  }
  /// Writes a state that was kept in memory. `progress` was returned by here() at that
  /// time.
  void good_checkpoint(const Model& model, const output::Progress& progress) {
    checkpoint_at(checkpoint_path(), model, progress,
                  {progress.frames, progress.listing_bytes});
  }
  /// Writes the checkpoint of a SAVE card. An older file with this path that is not of
  /// this deck gets the ending .bak, .bak2, ... first. Returns a warning about it, or
  /// an empty text. Throws FileError if another program is writing it.
  std::string save(const std::string& path, const Model& model,
                   const output::Progress& progress);
  /// Writes the files NAME.ENDING.vtkhdf, .out, .ckpt.h5 and .summary.json with the
  /// frames of two states. Files that this run wrote with this ending are replaced;
  /// others are kept as those of a run are. `what` is for the listing. Returns a
  /// warning about older files, or an empty text.
  std::string keep_state(const std::string& ending, const std::string& what,
                         const Model& before, const Model& after,
                         const output::Progress& progress);
  /// Renames files with this ending that an earlier run has left, as those of a run
  /// are. Returns a warning if they are of another deck, or an empty text.
  std::string move_state_aside(const std::string& ending);
  /// Returns `progress` with the present lengths of results and listing.
  output::Progress here(output::Progress progress);
  /// Writes the last frame, closing table, checkpoint and summary. If the same deck
  /// resumes from this checkpoint, the frame and the table are discarded. A frame of
  /// this step that is there already is the last one unless the model has `changed`.
  void close(const Model& model, output::RunReport report,
             const output::Progress& progress, bool changed = false);

  /// Describes the older files that were renamed if they belong to another deck;
  /// otherwise empty.
  const std::string& put_aside() const { return put_aside_; }

  std::string checkpoint_path() const { return name_ + ".ckpt.h5"; }
  std::string summary_path() const { return name_ + ".summary.json"; }
  std::string results_path() const { return name_ + ".vtkhdf"; }

 private:
  /// The lengths of results and listing that a run after the checkpoint keeps.
  struct Kept {
    long frames, bytes;
  };
  RunFiles(std::string name, const output::RunIdentity& identity, Kept kept,
           long kept_samples);
  std::string step_aside(const std::string& path);
  static bool continues(const std::string& name, const output::CheckpointInfo& from,
                        long listing_bytes, const std::string& checkpoint);
  void checkpoint_at(const std::string& path, const Model& model,
                     const output::Progress& progress, Kept kept);

  std::string name_;
  output::RunIdentity identity_;
  /// Older files that were renamed. If no frame is written, the destructor restores
  /// their names. Until the first frame, the older results also keep their name.
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
  bool resumed_ = false;        ///< it is the run of the files themselves
  std::set<std::string> kept_;  ///< endings of keep_state()
};

}  // namespace blocks::run
