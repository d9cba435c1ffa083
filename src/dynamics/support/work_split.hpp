// Which part of a step's work each thread begins with.
#pragma once

#include <cstddef>
#include <vector>

namespace blocks::dynamics {

/// Thread k begins with items [k] .. [k + 1] - 1 of each column. Wherever as many
/// threads take part, these are windows of pairs, the lanes of these pairs, and the
/// blocks that are the lower ones of them: what a thread has moved, it needs next, and
/// few blocks go from the cache of one core to that of another.
struct WorkSplit {
  std::vector<int> windows, batches, blocks;

  /// Of a new list, whose pairs have no lanes yet; so many pairs to a window.
  template <class Pair>
  void start(int block_count, const std::vector<Pair>& pairs, int window,
             int thread_count) {
    first_block_.clear();
    for (std::size_t p = 0; p < pairs.size(); p += static_cast<std::size_t>(window))
      first_block_.push_back(first_block_.empty() ? 0 : pairs[p].low);
    first_block_.push_back(block_count);
    split_windows(thread_count);
  }
  /// Splits the batches. first_batch: (windows + 1) the first one of each window.
  void split_batches(const std::vector<int>& first_batch);
  /// Splits so many other items evenly, at least `least` to a thread if there are as
  /// many. Does not allocate once `begins` has had room for all threads.
  void split_evenly(int count, int least, std::vector<int>& begins) const;

 private:
  void split_windows(int thread_count);
  int first_window(int share, int shares) const;

  int threads_ = 1;
  std::vector<int> first_block_;  ///< (windows + 1) lowest block of each; all blocks
};

}  // namespace blocks::dynamics
