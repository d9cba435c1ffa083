// Joint ids of the faces of blocks.
#pragma once

#include <string>
#include <vector>

#include "deck/commands.hpp"
#include "model/blocks.hpp"

namespace blocks::run {

/// Gives the ids to the sides of a block of a layer, whose corners are bottom left, top
/// left, top right and bottom right.
void give_layer_joints(const deck::FaceIds& ids, NewBlock& block);

/// Gives the ids to the sides that have none. A side whose outward normal is within 45
/// degrees of up or down is a top or a bottom.
void give_face_joints(const deck::FaceIds& ids, NewBlock& block);

/// Returns " between joints 1, 3" for the ids of the sides of a block, or an empty text
/// without joints.
std::string between_joints(const std::vector<int>& joints);

}  // namespace blocks::run
