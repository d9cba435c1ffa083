#include "run/builder/block_numbers.hpp"

#include <algorithm>
#include <cstdlib>

namespace blocks::run {
namespace {

constexpr long any_number = deck::UnreadCard::any_number_of_blocks;

/// The number of blocks that a card should make at most.
long max_new_blocks(const deck::Command& command) {
  if (const auto* create = std::get_if<deck::Create>(&command.card))
    return create->loop ? std::min(create->loop->nloop.value, any_number) : 1;
  if (const auto* layer = std::get_if<deck::Layer>(&command.card))
    return std::min(std::abs(layer->ns.value), any_number);
  return std::holds_alternative<deck::Read9>(command.card) ||
                 std::holds_alternative<deck::Cut>(command.card)
             ? any_number
             : 0;
}

}  // namespace

void BlockNumbers::count(int line, int blocks) {
  for (; unread_counted_ < unread_.size() && unread_[unread_counted_].where.line < line;
       ++unread_counted_)
    if (const deck::UnreadCard& card = unread_[unread_counted_]; card.name == "CREATE")
      add_gap(blocks, card.blocks);
  if (max_missing(line) == missing_)
    certain_ = blocks;
}

void BlockNumbers::add_failed(const deck::Command& command, int blocks) {
  const long failed = max_new_blocks(command);
  failed_ += failed;
  if (std::holds_alternative<deck::Create>(command.card))
    add_gap(blocks, failed);
}

void BlockNumbers::add_gap(int before, long count) {
  gaps_.push_back({before, count});
  missing_ += count;
}

void BlockNumbers::may_split(int blocks) {
  if (!before_splits_)
    before_splits_ = last(blocks);
}

long BlockNumbers::max_missing(int line) const {
  long unread = 0;
  for (const deck::UnreadCard& card : unread_)
    if (card.where.line < line)
      unread = std::min(unread + card.blocks, any_number);
  return failed_ + unread;
}

long BlockNumbers::number_of(int block) const {
  long number = block + 1L;
  for (const Gap& gap : gaps_)
    if (gap.before <= block)
      number += gap.count;
  return number;
}

int BlockNumbers::index_of(long number) const {
  long index = number - 1;
  for (const Gap& gap : gaps_) {
    if (index < gap.before)
      break;
    if (index < gap.before + gap.count)
      return -1;
    index -= gap.count;
  }
  return index < certain_ ? static_cast<int>(index) : -1;
}

}  // namespace blocks::run
