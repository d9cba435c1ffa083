// Where a joint set starts if its card does not say so (docs/joints.md).
#pragma once

#include <string>
#include <vector>

#include "geometry/joint_sources.hpp"

namespace blocks::run {

/// Lets a set that starts at (0, 0) start at the first corner of the outline instead if
/// (0, 0) is far from it, or if many more joints would be generated than meet the
/// outline. outline: [L] clockwise. Returns the reason; empty if the set stays as it
/// is.
std::string start_nearby(geometry::JointSet& set,
                         const std::vector<geometry::DecimalPoint>& outline);

}  // namespace blocks::run
