#include "dynamics/third_blocks.hpp"

#include <algorithm>

namespace blocks::dynamics {

void ThirdBlocks::reserve(int windows) {
  if (place(windows) > room_) {
    thirds_.reset();  // not beside the new ones
    thirds_ = std::make_unique_for_overwrite<ThirdBlock[]>(place(windows));
    room_ = place(windows);
  }
  count_.assign(windows, 0);
}

void ThirdBlocks::forget() { std::fill(count_.begin(), count_.end(), 0); }

bool ThirdBlocks::add(int window, const ThirdBlock& third) {
  if (count_[window] == most)
    return false;
  thirds_[place(window) + count_[window]++] = third;
  return true;
}

void ThirdBlocks::drop(int window, int group) {
  if (count_[window] == 0)
    return;
  ThirdBlock* const first = thirds_.get() + place(window);
  const auto of_group = [&](const ThirdBlock& third) { return third.group == group; };
  // not where nothing changes: other threads read counts that stand beside this one
  if (const auto left = std::remove_if(first, first + count_[window], of_group) - first;
      left != count_[window])
    count_[window] = static_cast<std::uint8_t>(left);
}

}  // namespace blocks::dynamics
