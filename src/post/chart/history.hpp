// `blocks history`: quantities of blocks, corners and the whole model over time
// (successor of NEWTEN and TPLOT2, report Appendix F).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "post/read/results_reader.hpp"
#include "post/read/units.hpp"
#include "quantities/curve_values.hpp"

namespace blocks::post {

using quantities::Curve;

/// One curve with its values; NaN while its blocks do not exist.
struct Series {
  Curve curve;
  std::string label;     ///< "speed of block 9"
  std::string quantity;  ///< "speed", "stress 11, tension positive"
  Dimension dimension;
  std::vector<double> values;  ///< (times)
};

/// The histories of one run.
struct History {
  std::string file, title;
  std::vector<double> time;  ///< (times) ascending
  std::vector<Series> series;
  /// Why the curves are those of the frames although some of them were recorded; empty
  /// if they are samples, or if none of them was recorded.
  std::string without_samples = {};
};

/// Times outside this range are left out.
struct TimeRange {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// Reads the samples of HISTORY cards if they have all curves, otherwise the frames,
/// one at a time. `frames` means the frames in any case. `materials` has the names of
/// materials that curves may use besides numbers.
///
/// `parts` are the results of one run in the order of time (post/read/run_parts.hpp). A
/// part ends where the next one begins. Displacements are relative to the first frame
/// of the first part.
///
/// Throws std::runtime_error if a block, a corner or a material never exists, or if no
/// time is in the range; the message says what exists.
History read_history(const std::vector<const ResultsReader*>& parts,
                     const std::vector<Curve>& curves, const TimeRange& range = {},
                     bool frames = false,
                     const quantities::MaterialNumbers& materials = {});

/// Returns the curves that the run recorded last; none without a HISTORY card.
std::vector<Curve> recorded_curves(const ResultsReader& results);

}  // namespace blocks::post
