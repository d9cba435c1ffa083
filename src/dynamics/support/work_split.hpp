// Divides the work of a step among the threads.
#pragma once

#include <cstddef>
#include <vector>

namespace blocks::dynamics {

/// Each column holds the borders of the shares: thread k begins with the half-open
/// range from item [k] to item [k + 1]. If all columns have the same number of shares,
/// share k consists of windows of pairs, their batches and the lower blocks of these
/// pairs. A thread then finds in its cache most of what it has written before, and few
/// blocks are exchanged between the caches of cores.
struct WorkSplit {
  std::vector<int> windows, batches, blocks;

  /// Divides the pairs of a new list and the blocks. The pairs have no batches yet.
  /// `window` is the number of pairs in a window.
  template <class Pair>
  void start(int block_count, const std::vector<Pair>& pairs, int window,
             int thread_count) {
    first_block_.clear();
    for (std::size_t p = 0; p < pairs.size(); p += static_cast<std::size_t>(window))
      first_block_.push_back(first_block_.empty() ? 0 : pairs[p].low);
    first_block_.push_back(block_count);
    split_windows(thread_count);
  }
  /// Divides the batches. first_batch: (windows + 1) the first batch of each window.
  void split_batches(const std::vector<int>& first_batch);

 private:
  void split_windows(int thread_count);
  int first_window(int share, int shares) const;

  int threads_ = 1;
  /// (windows + 1) The lowest block of each window, 0 for the first one, then the
  /// number of blocks.
  std::vector<int> first_block_;
};

}  // namespace blocks::dynamics
