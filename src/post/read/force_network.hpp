// The contact forces of a frame as a network: one link for each pair of touching
// blocks.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "post/read/results_reader.hpp"

namespace blocks::post {

/// The resultant of all contacts between two blocks.
struct ForceLink {
  int first = 0, second = 0;  ///< blocks from 0; first is -1 for symmetry planes
  Eigen::Vector2d point;      ///< [L] mean of the contacts, weighted by their forces
  Eigen::Vector2d force;      ///< [F] on `second`; the opposite acts on `first`
};

/// Returns the links in order of increasing force; pairs without force are left out.
std::vector<ForceLink> force_network(const FrameContacts& contacts);

}  // namespace blocks::post
