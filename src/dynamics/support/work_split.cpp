#include "dynamics/support/work_split.hpp"

#include <algorithm>

namespace blocks::dynamics {
namespace {

/// With fewer items than this, another thread costs more time than it saves.
constexpr int batches_per_thread = 128, blocks_per_thread = 128;

int shares_of(int threads, int count, int min) {
  return std::max(1, std::min(threads, count / min));
}

}  // namespace

void WorkSplit::split_windows(int thread_count) {
  threads_ = thread_count;
  const int block_count = first_block_.back();
  const int window_count = static_cast<int>(first_block_.size()) - 1;
  const int by_windows = shares_of(threads_, window_count, 1);
  windows.resize(by_windows + 1);
  for (int k = 0; k <= by_windows; ++k)
    windows[k] = first_window(k, by_windows);

  const int by_blocks = shares_of(threads_, block_count, blocks_per_thread);
  blocks.resize(by_blocks + 1);
  for (int k = 0; k <= by_blocks; ++k)
    blocks[k] = window_count < by_blocks
                    ? static_cast<int>(long{block_count} * k / by_blocks)
                    : first_block_[first_window(k, by_blocks)];
  batches.reserve(threads_ + 1);
}

void WorkSplit::split_batches(const std::vector<int>& first_batch) {
  const int shares = shares_of(threads_, first_batch.back(), batches_per_thread);
  batches.resize(shares + 1);
  for (int k = 0; k <= shares; ++k)
    batches[k] = first_batch[first_window(k, shares)];
}

/// Returns the first window of a share. Contacts take about three quarters of the time
/// of a step and blocks one quarter, so the shares balance both.
int WorkSplit::first_window(int share, int shares) const {
  const int last = static_cast<int>(first_block_.size()) - 1;
  const double all_windows = std::max(1, last), all_blocks = first_block_.back() + 1.0;
  const double wanted = static_cast<double>(share) / shares;
  const auto part_before = [&](int window) {
    return 0.75 * window / all_windows + 0.25 * first_block_[window] / all_blocks;
  };
  int window = share == shares ? last : 0;
  while (window < last && part_before(window) < wanted)
    ++window;
  return window;
}

}  // namespace blocks::dynamics
