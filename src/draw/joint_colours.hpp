// How the joints of a model are drawn: one colour and one pattern of dashes for each
// joint id.
#pragma once

#include <cstddef>

#include "draw/colour_map.hpp"

namespace blocks::draw {

class Pen;

/// Number of joint ids that a legend lists.
constexpr std::size_t max_joints_listed = 16;

/// Returns the colour of a joint, id >= 1. The first eight differ for colour-blind
/// readers, and the first four also as greys. Later ids have tints of these colours.
Colour joint_colour(int id);

/// Sets the dashes of a joint, id >= 1: none for the first eight ids.
void set_joint_dashes(Pen& pen, int id);

/// The colour of sides without a joint.
constexpr Colour no_joint_colour{0.68, 0.68, 0.7};

}  // namespace blocks::draw
