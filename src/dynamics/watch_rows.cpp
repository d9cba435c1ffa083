#include "dynamics/watch_rows.hpp"

#include <algorithm>

namespace blocks::dynamics {

void WatchRows::reserve(int rounds, int rounds_of_window) {
  rounds_of_window_ = rounds_of_window;
  const std::size_t windows = rounds / rounds_of_window + 1;
  rows_.reset();  // not beside the new ones
  rows_ = std::make_unique_for_overwrite<WatchRow[]>(windows * rows_of_window);
  taken_.assign(windows, 0);
  first_.assign(rounds, 0);
  count_.assign(rounds, none);
}

void WatchRows::forget() {
  std::fill(taken_.begin(), taken_.end(), 0);
  std::fill(count_.begin(), count_.end(), none);
}

void WatchRows::forget(int round) {
  if (const int count = count_[round]; count <= most)
    taken_[round / rounds_of_window_] &= ~(((1ULL << count) - 1) << first_[round]);
  count_[round] = none;
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
  const int count = count_ / lane_count;
  const std::uint64_t wanted = (1ULL << count) - 1;
  std::uint64_t& taken = rows.taken_[round / rows.rounds_of_window_];
  for (int first = 0; first + count <= rows_of_window; ++first)
    if ((taken >> first & wanted) == 0) {
      taken |= wanted << first;
      rows.first_[round] = static_cast<std::uint8_t>(first);
      rows.count_[round] = static_cast<std::uint8_t>(count);
      std::copy_n(made_.begin(), count, rows.rows_.get() + rows.place(round));
      return;
    }
}

}  // namespace blocks::dynamics
