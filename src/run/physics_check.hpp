// Warns of decks whose numbers do not fit together: springs too soft for the weight on
// them, and a contact tolerance too large for the blocks.
#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"

namespace blocks::run {

/// A warning without its place in the deck.
struct Doubt {
  std::string message, hint;
};

/// Estimates the overlap at rest under gravity: the weight W of the heaviest column of
/// free blocks on its lowest block, divided by the normal stiffness Kn. Returns a doubt
/// if it is more than a twentieth of the least width of that block.
std::optional<Doubt> doubt_stiffness(const Model& model);

/// Returns a doubt if the contact tolerance is more than the least width of the
/// narrowest free block.
std::optional<Doubt> doubt_tolerance(const Model& model);

}  // namespace blocks::run
