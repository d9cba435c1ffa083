// `blocks history`: quantities of blocks, corners and the whole model against time
// (heir of NEWTEN and TPLOT2, report Appendix F).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "post/curve.hpp"
#include "post/results_reader.hpp"
#include "post/units.hpp"

namespace blocks::post {

/// One curve with its numbers; NaN where the block is not there yet.
struct Series {
  Curve curve;
  std::string label;     ///< "speed of block 9"
  std::string quantity;  ///< "speed"
  Dimension dimension;
  std::vector<double> values;  ///< (frames)
};

/// The histories of one run.
struct History {
  std::string file, title;
  std::vector<double> time;  ///< (frames)
  std::vector<Series> series;
};

/// Times outside are left out.
struct TimeRange {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// Reads the frames once, in the memory of one. Throws std::runtime_error when a block
/// or corner never exists or no frame lies in the range, naming what there is.
History read_history(const ResultsReader& results, const std::vector<Curve>& curves,
                     const TimeRange& range = {});

}  // namespace blocks::post
