// Warns of blocks outside XLIMITS and YLIMITS, which the first step after them fixes.
#pragma once

#include <array>
#include <optional>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "model/model.hpp"
#include "run/block_makers.hpp"

namespace blocks::run {

/// The places of the XLIMITS and the YLIMITS card, if the deck has them.
using DomainCards = std::array<std::optional<deck::SourceLocation>, 2>;

/// Adds a warning for each of the two cards with the free blocks from `begin` on that
/// have a corner outside its limits. A block outside both is named once, with XLIMITS.
/// Without such a card, as in a restart, the warning is at `motion`.
void check_domain(const Model& model, int begin, const DomainCards& cards,
                  const BlockMakers& makers, const deck::Command& motion,
                  deck::Diagnostics& diagnostics);

}  // namespace blocks::run
