#include "dynamics/support/workers.hpp"

#include <algorithm>

namespace blocks::dynamics {
namespace {

/// Waits until done(number). Polls for some microseconds, then yields to other threads,
/// then sleeps. The phases of a step follow each other faster than a sleeping thread
/// wakes up, but there may be fewer cores than threads.
template <class Number, class Done>
Number wait_for(const std::atomic<Number>& number, const Done& done) {
  for (int i = 0; i < 600; ++i) {
    if (const Number now = number.load(std::memory_order_acquire); done(now))
      return now;
#if defined(__x86_64__)
    if (i < 500) {
      __builtin_ia32_pause();
      continue;
    }
#endif
    std::this_thread::yield();
  }
  for (;;) {
    const Number now = number.load(std::memory_order_acquire);
    if (done(now))
      return now;
    number.wait(now, std::memory_order_acquire);
  }
}

/// Each piece but the last is half of what is left of the share. So the last pieces are
/// small, and the wait for the slowest thread is short. A thread that takes pieces of
/// another share takes small ones. This matters because blocks moved by another thread
/// have to pass from cache to cache.
constexpr std::uint32_t pieces_of_share = 5;

struct Range {
  int first, last;
};
Range piece_of(Range share, std::uint32_t piece) {
  const int count = share.last - share.first;
  const auto left = [&](std::uint32_t k) {
    return k < pieces_of_share ? count >> k : 0;
  };
  return {share.last - left(piece), share.last - left(piece + 1)};
}

}  // namespace

Workers::Workers(int threads)
    : shares_(
          std::make_unique<Share[]>(static_cast<std::size_t>(std::max(1, threads)))) {
  begins_.reserve(static_cast<std::size_t>(std::max(1, threads)) + 1);
  for (int thread = 1; thread < threads; ++thread)
    others_.emplace_back([this, thread] { serve(thread); });
}

Workers::~Workers() {
  over_ = true;
  ++number_;
  number_.notify_all();
  for (std::thread& other : others_)
    other.join();
}

void Workers::split_evenly(int count, int min) {
  const int shares = std::max(1, std::min(threads(), count / min));
  begins_.resize(static_cast<std::size_t>(shares) + 1);
  for (int k = 0; k <= shares; ++k)
    begins_[static_cast<std::size_t>(k)] = static_cast<int>(long{count} * k / shares);
}

void Workers::run(const Task& task) {
  task_ = task;
  const std::uint32_t number = number_.load(std::memory_order_relaxed) + 1;
  undone_.store(task.shares * static_cast<int>(pieces_of_share),
                std::memory_order_relaxed);
  for (int share = 0; share < task.shares; ++share)
    shares_[share].next.store(std::uint64_t{number} << 32, std::memory_order_release);
  number_.store(number, std::memory_order_release);
  number_.notify_all();
  take_pieces(0, number);
  wait_for(undone_, [](int left) { return left == 0; });
}

void Workers::take_pieces(int thread, std::uint32_t number) {
  const int all = threads();
  int done = 0;
  for (int k = 0; k < all; ++k) {  // the thread's own share comes first
    const int share = (thread + k) % all;
    std::atomic<std::uint64_t>& next = shares_[share].next;
    std::uint64_t at = next.load(std::memory_order_acquire);
    while (at >> 32 == number && static_cast<std::uint32_t>(at) < pieces_of_share) {
      if (!next.compare_exchange_weak(at, at + 1, std::memory_order_acq_rel,
                                      std::memory_order_acquire))
        continue;
      // There is no other task until this piece is reported as done.
      const Range piece = piece_of({task_.begins[share], task_.begins[share + 1]},
                                   static_cast<std::uint32_t>(at));
      if (piece.first < piece.last)
        task_.call(task_.work, thread, piece.first, piece.last);
      ++done;
      at = next.load(std::memory_order_acquire);
    }
  }
  if (done > 0 && undone_.fetch_sub(done, std::memory_order_acq_rel) == done)
    undone_.notify_one();
}

void Workers::serve(int thread) {
  for (std::uint32_t seen = 0;;) {
    seen = wait_for(number_, [&](std::uint32_t now) { return now != seen; });
    if (over_)
      return;
    take_pieces(thread, seen);
  }
}

}  // namespace blocks::dynamics
