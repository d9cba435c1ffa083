// Threads that share the work of a step. Results do not depend on which thread computes
// an item: every item is computed on its own, and sums are taken in a fixed order.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace blocks::dynamics {

class Workers {
 public:
  /// Starts threads - 1 threads; the calling thread is the first worker. threads: at
  /// least 1.
  explicit Workers(int threads = 1);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const { return static_cast<int>(others_.size()) + 1; }
  /// Adds the time that calls of each() take to a number, [s].
  void measure(double* seconds) { seconds_ = seconds; }

  /// Calls work(thread, first, last) for ranges of items on all threads at the same
  /// time. A thread may be called any number of times. Thread k begins with the
  /// half-open range from begins[k] to begins[k + 1]. There is at least one such range,
  /// and there are at most as many as threads. Idle threads take pieces that other
  /// threads have not started, so that no thread waits for one that has no core.
  /// Returns when all items are done. `work` must not throw and must not call each().
  /// Allocates nothing.
  template <class Work> void each(const std::vector<int>& begins, const Work& work) {
    const Watch watch(seconds_);
    const int shares = static_cast<int>(begins.size()) - 1;
    if (shares == 1) {
      work(0, begins.front(), begins.back());
      return;
    }
    const auto call = [](const void* what, int thread, int first, int last) {
      (*static_cast<const Work*>(what))(thread, first, last);
    };
    run({call, &work, begins.data(), shares});
  }
  /// The same for `count` items in equal shares, each of at least `min` items if
  /// there are as many.
  template <class Work> void each_evenly(int count, int min, const Work& work) {
    split_evenly(count, min);
    each(begins_, work);
  }

 private:
  /// Adds the time until it is destroyed, if there is a number to add it to.
  class Watch {
   public:
    explicit Watch(double* seconds) : seconds_(seconds) {
      if (seconds_ != nullptr)
        began_ = std::chrono::steady_clock::now();
    }
    ~Watch() {
      if (seconds_ != nullptr)
        *seconds_ +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began_)
                .count();
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    double* seconds_;
    std::chrono::steady_clock::time_point began_;
  };
  struct Task {
    void (*call)(const void*, int, int, int) = nullptr;
    const void* work = nullptr;
    const int* begins = nullptr;
    int shares = 0;
  };
  /// The rest of one thread's share. The upper 32 bits are the number of the task, the
  /// lower 32 bits the index of the next piece.
  struct alignas(64) Share {
    std::atomic<std::uint64_t> next = ~std::uint64_t{0};
  };
  void split_evenly(int count, int min);
  void run(const Task& task);
  void take_pieces(int thread, std::uint32_t number);
  void serve(int thread);

  Task task_;  ///< read only by threads that have taken a piece of it
  std::atomic<std::uint32_t> number_ = 0;  ///< number of the current task, from 1
  std::atomic<int> undone_ = 0;  ///< pieces of the current task that are not done
  std::atomic<bool> over_ = false;
  std::unique_ptr<Share[]> shares_;  ///< (threads)
  std::vector<std::thread> others_;
  std::vector<int> begins_;  ///< of the shares of each_evenly
  double* seconds_ = nullptr;
};

}  // namespace blocks::dynamics
