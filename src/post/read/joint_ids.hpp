// The joint ids of the sides of blocks.
#pragma once

#include <set>
#include <string>

#include "post/read/results_reader.hpp"

namespace blocks::post {

/// Returns the joint ids other than 0 of a frame.
std::set<int> joints_of(const Frame& frame);

/// Returns "no side of a block has a joint id ..." with a hint.
std::string no_joints_text();

}  // namespace blocks::post
