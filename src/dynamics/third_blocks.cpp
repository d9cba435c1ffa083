#include "dynamics/third_blocks.hpp"

#include <algorithm>

namespace blocks::dynamics {

void ThirdBlocks::reserve(int rounds) {
  if (place(rounds) > room_) {
    thirds_.reset();  // not beside the new ones
    thirds_ = std::make_unique_for_overwrite<ThirdBlock[]>(place(rounds));
    room_ = place(rounds);
  }
  count_.assign(rounds, 0);
}

void ThirdBlocks::forget() { std::fill(count_.begin(), count_.end(), 0); }

bool ThirdBlocks::add(int round, const ThirdBlock& third) {
  if (count_[round] == most)
    return false;
  thirds_[place(round) + count_[round]++] = third;
  return true;
}

void ThirdBlocks::drop(int round, int group) {
  ThirdBlock* const first = thirds_.get() + place(round);
  const auto of_group = [&](const ThirdBlock& third) { return third.group == group; };
  count_[round] = static_cast<std::uint8_t>(
      std::remove_if(first, first + count_[round], of_group) - first);
}

}  // namespace blocks::dynamics
