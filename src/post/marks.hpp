// Places of a figure that deserve a look: a colour and a shape for each kind, so that
// marks of several kinds at one place can be told apart.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "post/colour_map.hpp"

struct _cairo;  // cairo_t NOLINT(bugprone-reserved-identifier)

namespace blocks::post {

struct Mark {
  enum class Kind { overlap, gap, junction, slender, edge, angle };
  Kind kind = Kind::overlap;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< [L]
  std::string label;                                ///< written beside it; may be empty
  std::vector<int> blocks;  ///< drawn over in the mark's colour, from 0
};

/// A line of the legend.
struct MarkName {
  Mark::Kind kind;
  std::string name;   ///< "overlap"
  std::string count;  ///< "3", "10 of 212"
};

Colour mark_colour(Mark::Kind kind);

/// Sets the outline of the mark as the pen's path. x, y, radius in page units.
void trace_mark(_cairo* pen, Mark::Kind kind, double x, double y, double radius);

}  // namespace blocks::post
