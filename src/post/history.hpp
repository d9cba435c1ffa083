// `blocks history`: quantities of blocks, corners and the whole model over time
// (successor of NEWTEN and TPLOT2, report Appendix F).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "post/curve.hpp"
#include "post/results_reader.hpp"
#include "post/units.hpp"

namespace blocks::post {

/// One curve with its values; NaN while the block does not exist yet.
struct Series {
  Curve curve;
  std::string label;     ///< "speed of block 9"
  std::string quantity;  ///< "speed", "stress 11, tension positive"
  Dimension dimension;
  std::vector<double> values;  ///< (frames)
};

/// The histories of one run.
struct History {
  std::string file, title;
  std::vector<double> time;  ///< (frames)
  std::vector<Series> series;
};

/// Times outside this range are left out.
struct TimeRange {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// Reads the frames once, one at a time. `parts` are the results of one run in the
/// order of time (post/run_parts.hpp). A part ends where the next one begins;
/// displacements are relative to the first frame of the first part. Throws
/// std::runtime_error if a block or corner never exists, or if no frame is in the
/// range; the message says what exists.
History read_history(const std::vector<const ResultsReader*>& parts,
                     const std::vector<Curve>& curves, const TimeRange& range = {});

}  // namespace blocks::post
