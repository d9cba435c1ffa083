#include "dynamics/watch_rows.hpp"

#include <algorithm>
#include <bitset>

namespace blocks::dynamics {

void WatchRows::reserve(int rounds, int rounds_of_window) {
  rounds_of_window_ = rounds_of_window;
  const std::size_t windows = rounds / rounds_of_window + 1;
  rows_.reset();  // not beside the new ones
  rows_ = std::make_unique_for_overwrite<WatchRow[]>(windows * rows_of_window);
  first_.assign(rounds, 0);
  count_.assign(rounds, none);
}

void WatchRows::forget() { std::fill(count_.begin(), count_.end(), none); }

void WatchRows::forget(int round) { count_[round] = none; }

int WatchRows::room(int round, int count) const {
  std::bitset<rows_of_window> taken;
  const int begin = round / rounds_of_window_ * rounds_of_window_;
  const int end = std::min(begin + rounds_of_window_, static_cast<int>(count_.size()));
  for (int other = begin; other < end; ++other)
    for (int k = 0; count_[other] <= most && k < count_[other]; ++k)
      taken.set(first_[other] + k);
  for (int last = 0, free = 0; last < rows_of_window; ++last) {
    free = taken[last] ? 0 : free + 1;
    if (free == count)
      return last + 1 - count;
  }
  return -1;
}

void WatchRows::Maker::add(int corner, int edge, int edge_end, bool outside) {
  const int row = count_ / lane_count, k = count_ % lane_count;
  ++count_;
  if (row >= most)
    return;
  WatchRow& into = made_[row];
  if (k == 0)
    into.outside = 0;
  into.corner[k] = corner, into.edge[k] = edge, into.edge_end[k] = edge_end;
  into.outside = static_cast<LaneBits>(into.outside | unsigned{outside} << k);
}

void WatchRows::Maker::finish(WatchRows& rows, int round) {
  rows.count_[round] = no_room;
  if (count_ == 0 || count_ > most * lane_count)
    return;
  // lanes that are left ask what the first of their row does
  const WatchRow& last = made_[(count_ - 1) / lane_count];
  while (count_ % lane_count != 0)
    add(last.corner[0], last.edge[0], last.edge_end[0], (last.outside & 1U) != 0);
  const int count = count_ / lane_count, first = rows.room(round, count);
  if (first < 0)
    return;
  rows.first_[round] = static_cast<std::uint8_t>(first);
  rows.count_[round] = static_cast<std::uint8_t>(count);
  std::copy_n(made_.begin(), count, rows.rows_.get() + rows.place(round));
}

}  // namespace blocks::dynamics
