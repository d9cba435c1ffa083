// Records the histories of the HISTORY card between the steps of a run.
#pragma once

#include <limits>
#include <vector>

#include "model/model.hpp"
#include "output/results/results.hpp"
#include "quantities/curve_values.hpp"
#include "quantities/multiples.hpp"

namespace blocks::run {

/// A sample belongs to a multiple of the interval. Its values are interpolated linearly
/// between the states before and after it, so both must be read. The numbers of blocks
/// and of cracks are those before it. All values are
/// computed by one thread in the order of the blocks, so they do not depend on the
/// number of threads.
class HistoryRecorder {
 public:
  explicit HistoryRecorder(output::ResultsWriter& results) : results_(&results) {}

  /// Call it before the steps of a card, when the model is up to date and the results
  /// have a frame. Adds a sample if the time of the model is a multiple that has none.
  void begin(const Model& model);
  /// Whether record() must be called after the coming step or the one after it, because
  /// a sample lies there. later: [T] time of the later of the two, or slightly more.
  bool is_due(double later) const { return due_ <= later; }
  /// Adds the samples that lie between the last state that was recorded and this one.
  void record(const Model& model);

 private:
  void read(const Model& model, std::vector<double>& values);
  /// Makes the first positions those of the blocks of the model.
  void follow_blocks(const Model& model);
  void take_samples(double time);
  void set_next(long next);

  output::ResultsWriter* results_;
  HistoryRequest request_;
  std::vector<bool> is_count_;  ///< (curves) such values are not interpolated
  quantities::CurveValues values_of_{{}};
  quantities::Multiples multiples_{1.0};
  output::FirstPositions first_;
  int first_blocks_ = 0;  ///< blocks of the first frame
  std::vector<quantities::ContactState> contacts_;
  Eigen::VectorXd unbalanced_;    ///< [F] (blocks) in the state that is read
  Eigen::Matrix2Xd water_;        ///< [F] (2, blocks) there
  Eigen::VectorXd local_ratios_;  ///< (blocks) in that state
  long next_ = 0;                 ///< index of the next multiple
  /// [T] samples are due from this time on; infinite if there is no HISTORY card.
  double due_ = std::numeric_limits<double>::infinity();
  double time_before_ = 0.0;  ///< [T] of the state recorded last
  std::vector<double> before_, now_, sample_;
};

}  // namespace blocks::run
