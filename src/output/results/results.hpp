// NAME.vtkhdf, which replaces the plot tape of the report. It is a transient
// unstructured grid of polygons for ParaView, with all block quantities as cell data
// (report A.2.18, Appendix G.1).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace blocks::output {

/// The identity of a run. It is written once, when the results file is created.
struct RunIdentity {
  std::string deck_file, deck_text, title, version;
  unsigned long long seed = 0;
  std::string overrides = {};  ///< --set options and mesh hashes, one per line
  /// The run_id of other results whose run this one continues; empty for a new run.
  std::string continues_run = {};

  /// The file name and the title of the deck.
  std::string deck_name() const;
  /// Whether the name, title, text, options and seed of the decks are identical.
  bool same_deck(const RunIdentity& other) const;
};

/// Centroids, [L] (2, n), and corners of blocks, [L].
struct FirstPositions {
  Eigen::Matrix2Xd centroid;
  std::vector<std::vector<Eigen::Vector2d>> outlines;
};

/// Appends frames to a file that other programs can read at any moment.
class ResultsWriter {
 public:
  /// Creates the file as PATH.tmp. After the first frame it is renamed to PATH, and an
  /// existing file is renamed to PATH + `aside`; by default to the first of PATH.bak,
  /// PATH.bak2, ... that is free.
  ResultsWriter(const std::string& path, const RunIdentity& identity,
                std::string aside = {});
  /// Opens an existing file, keeps its first `frames` frames and the first `samples`
  /// samples of its histories, and continues after them.
  static ResultsWriter reopen(const std::string& path, long frames, long samples = 0);
  ~ResultsWriter();
  ResultsWriter(ResultsWriter&&) noexcept;
  ResultsWriter& operator=(ResultsWriter&&) noexcept;

  /// The random identifier of the file. A checkpoint stores it to identify its results.
  std::string run_id() const;
  /// The identifier of a file; empty if it cannot be read or is not a results file.
  static std::string run_id_of(const std::string& path);
  /// The identity of the run that wrote a file; empty if it cannot be read or is not a
  /// results file.
  static std::optional<RunIdentity> identity_of(const std::string& path);

  /// Demands the unbalanced forces of blocks in all frames. Has no effect on a file
  /// that has frames.
  void include_unbalanced();
  /// Appends the state. If the last frame already has this step, does nothing unless
  /// the state has `changed` since.
  void write(const Model& model, bool changed = false);
  long frames() const;

  /// Begins to record histories. Returns the time of the last sample in the file if
  /// the request continues that of the last section (results_history.hpp).
  std::optional<double> begin_history(const HistoryRequest& request);
  /// Adds a sample to the histories. It is in the file after the next frame or
  /// flush_history().
  void add_sample(double time, std::span<const double> values);
  void flush_history();
  /// The number of samples added so far, in the whole file.
  long samples() const;

  /// Where the blocks of the first frame are. There must be a frame.
  FirstPositions first_positions() const;

 private:
  struct File;
  explicit ResultsWriter(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

}  // namespace blocks::output
