// The blocks, sides and corners that cards name by numbers or by selectors
// (docs/selectors.md). Selectors never find blocks that are removed, or that may be
// removed before the run gets here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/selection.hpp"
#include "run/builder/context.hpp"

namespace blocks::run {

/// Sides that a card names, and the line on which a selector has found them.
struct SelectedSides {
  std::vector<BlockSide> sides;
  std::optional<Plane> line = {};
};

/// Returns the blocks of a selector. Reports an error if there are none.
std::vector<int> select_blocks(const Context& context, deck::SourceLocation where,
                               const deck::Selector& selector);

/// Returns the corner of a selector nearest(x, y). Reports an error if there is none.
std::optional<BlockCorner> select_corner(const Context& context,
                                         deck::SourceLocation where,
                                         const deck::Selector& selector);

/// Returns the blocks that a field names, and records the choice of a selector. Returns
/// nothing after an error or a warning.
std::vector<int> blocks_named(const Context& context,
                              const deck::NumberOrSelector& named);

/// Returns the block that a field names. Returns -1 after an error, which several
/// blocks are too, or a warning.
int block_named(const Context& context, const deck::NumberOrSelector& named);

/// Returns the sides that the fields for a block and a side name, and records the
/// choice of a selector. Returns nothing after an error or a warning.
SelectedSides sides_named(const Context& context, const deck::NumberOrSelector& block,
                          const deck::NumberOrSelector& side);

/// Reports that the selector of a field finds `how_many`, and the card takes one.
void error_several(const Context& context, const deck::NumberOrSelector& named,
                   const std::string& how_many);

}  // namespace blocks::run
