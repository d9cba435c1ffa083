// How the joints of a model are drawn: one colour and one pattern of dashes for each
// joint id.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "post/colour_map.hpp"
#include "post/results_reader.hpp"

namespace blocks::post {

class Pen;

/// Number of joint ids that a legend lists.
constexpr std::size_t most_joints_listed = 16;

/// Returns the colour of a joint, id >= 1. The first eight differ for colour-blind
/// readers, and the first four also as greys. Later ids have tints of these colours.
Colour joint_colour(int id);

/// Sets the dashes of a joint, id >= 1: none for the first eight ids.
void set_joint_dashes(Pen& pen, int id);

/// The colour of sides without a joint.
constexpr Colour no_joint_colour{0.68, 0.68, 0.7};

/// Returns the joint ids other than 0 of a frame.
std::set<int> joints_of(const Frame& frame);

/// Returns "no side of a block has a joint id ..." with a hint.
std::string no_joints_text();

}  // namespace blocks::post
