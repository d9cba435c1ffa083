#include "run/plausibility/block_makers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace blocks::run {

void BlockMakers::record(const deck::Command& card, int blocks) {
  if (blocks > (makers_.empty() ? before_ : makers_.back().end))
    makers_.push_back({blocks, card.name, card.where});
}

std::string BlockMakers::Maker::text() const {
  return fmt::format("{} in line {}", name, where.line);
}

const BlockMakers::Maker* BlockMakers::of(int block) const {
  const auto maker =
      std::upper_bound(makers_.begin(), makers_.end(), block,
                       [](int b, const Maker& one) { return b < one.end; });
  return block < before_ || maker == makers_.end() ? nullptr : &*maker;
}

}  // namespace blocks::run
