#include "run/builder/missing_blocks.hpp"

namespace blocks::run {

void MissingBlocks::add(int before, long count) {
  gaps_.push_back({before, count});
  count_ += count;
}

long MissingBlocks::number_of(int block) const {
  long number = block + 1L;
  for (const Gap& gap : gaps_)
    if (gap.before <= block)
      number += gap.count;
  return number;
}

long MissingBlocks::index_of(long number) const {
  long index = number - 1;
  for (const Gap& gap : gaps_) {
    if (index < gap.before)
      break;
    if (index < gap.before + gap.count)
      return -1;
    index -= gap.count;
  }
  return index;
}

}  // namespace blocks::run
