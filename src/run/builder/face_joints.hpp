// Joint ids of the bottom, top and side faces of blocks (LAYER and READ9 cards).
#pragma once

#include "deck/commands.hpp"
#include "model/blocks.hpp"

namespace blocks::run {

/// Gives the ids to the sides of a block of a layer, whose corners are bottom left, top
/// left, top right and bottom right.
void give_layer_joints(const deck::FaceIds& ids, NewBlock& block);

/// Gives the ids to the sides that have none. A side whose outward normal is within 45
/// degrees of up or down is a top or a bottom.
void give_face_joints(const deck::FaceIds& ids, NewBlock& block);

}  // namespace blocks::run
