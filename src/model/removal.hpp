// Removes blocks from the model and frees fixed ones (REMOVE, FREE;
// docs/theory.md#excavation). Independent of the step and of cards.
#pragma once

#include <vector>

#include "model/model.hpp"

namespace blocks {

/// Removes blocks. A removed block keeps its number, its place and its mass, but it is
/// at rest, free of force and stress, and touches nothing. Its contacts and loads are
/// deleted. If it had set the time step, the next motion chooses another one. chosen:
/// indices of blocks that are not removed yet.
void remove_blocks(Model& model, const std::vector<int>& chosen);

/// Frees blocks. The next motion chooses the time step of deformable blocks again,
/// because a free block may need a shorter one. chosen: indices of blocks that are
/// fixed by the user.
void free_blocks(Model& model, const std::vector<int>& chosen);

}  // namespace blocks
