// The blocks, sides and materials that cards name by their numbers. What may be missing
// because of a faulty card is no error.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "run/builder/context.hpp"

namespace blocks::run {

/// Returns whether there is a block with this number, counted from 1, or one that a
/// faulty card did not make. Otherwise reports an error.
bool has_block(const Context& context, const deck::Int& number);

/// Returns the index of the block with this number. Returns -1 after an error, for a
/// block that a faulty card has hidden, and for a removed block, with a warning that
/// the card has no effect.
int find_block_to_change(const Context& context, const deck::Int& number);

/// Returns the blocks of a range, or nothing after an error; nb2 is 0 for the first
/// block alone and negative for all blocks so far.
std::vector<int> find_blocks(const Context& context, const deck::Int& nb1,
                             const deck::Int& nb2);

/// Returns the blocks of a material. Returns nothing after an error, or if there are
/// none, with a warning.
std::vector<int> find_blocks_of(const Context& context, const deck::Int& material);

/// Deletes the removed blocks from the list. Warns that the card has no effect if no
/// others are in it.
void leave_out_removed(const Context& context, deck::SourceLocation where,
                       std::vector<int>& chosen);

/// Returns the side of block b with this number, from 0. Returns -1 after an error.
int find_side(const Context& context, int b, const deck::Int& number);

/// Returns whether block b is inside the domain, where blocks move. Otherwise reports
/// an error, or a warning if the block has left it.
bool can_move(const Context& context, int b, deck::SourceLocation where);

/// Returns whether the material is defined. Otherwise reports an error.
bool has_material(const Context& context, const deck::Int& number);

/// Returns the number of the material with this name or number; 0 after an error.
int find_material(const Context& context, deck::SourceLocation where,
                  const std::string& name);

/// Returns the beginning of a sentence: "block 3 is" or "blocks 3 to 5 are".
std::string blocks_are(const Context& context, const std::vector<int>& blocks);

/// Returns the hint of a warning that the card finds no blocks.
std::string place_hint(const Context& context);

/// Lists what is defined: "1, 4", or "none".
std::string listed(const auto& defined) {
  return defined.empty() ? "none" : fmt::format("{}", fmt::join(defined, ", "));
}
/// Lists the numbers under which something is defined.
template <class Value> std::string listed(const std::map<int, Value>& defined) {
  std::vector<int> numbers;
  for (const auto& [number, value] : defined)
    numbers.push_back(number);
  return listed(numbers);
}

}  // namespace blocks::run
