// Marks for places of interest in a figure. Each kind has its own colour and shape, so
// that different marks at one place can be distinguished.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "draw/colour_map.hpp"

struct _cairo;  // cairo_t NOLINT(bugprone-reserved-identifier)

namespace blocks::draw {

struct Mark {
  enum class Kind { overlap, gap, junction, slender, edge, angle };
  Kind kind = Kind::overlap;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< [L]
  std::string label;                                ///< written beside it; may be empty
  std::vector<int> blocks;  ///< blocks highlighted in the colour of the mark, from 0
};

/// A line of the legend.
struct MarkName {
  Mark::Kind kind;
  std::string name;   ///< "overlap"
  std::string count;  ///< "3", "10 of 212"
};

Colour mark_colour(Mark::Kind kind);

/// Makes the outline of the mark the current path of the pen. x, y and radius are in
/// page units.
void trace_mark(_cairo* pen, Mark::Kind kind, double x, double y, double radius);

}  // namespace blocks::draw
