// Threads that share the work of a step. Which thread does what never shows in a
// result: every item is computed on its own, and sums are taken in a fixed order.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace blocks::dynamics {

class Workers {
 public:
  /// This many threads, the calling one among them; at least 1.
  explicit Workers(int threads = 1);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const { return static_cast<int>(others_.size()) + 1; }

  /// Calls work(thread, first, last) for ranges of items, at the same time, any number
  /// of times for a thread. Of items begins[0] .. begins.back() - 1 thread k begins
  /// with begins[k] .. begins[k + 1] - 1: one thread or more, and not more than there
  /// are. Who is done takes what another has not begun, so that nobody waits for a
  /// thread without a core. Returns when all are done. `work` must not throw, and not
  /// call each(). Allocates nothing.
  template <class Work> void each(const std::vector<int>& begins, const Work& work) {
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

 private:
  struct Task {
    void (*call)(const void*, int, int, int) = nullptr;
    const void* work = nullptr;
    const int* begins = nullptr;
    int shares = 0;
  };
  /// What is left of the share of one thread: number of the task, and of the piece that
  /// comes next.
  struct alignas(64) Share {
    std::atomic<std::uint64_t> next = ~std::uint64_t{0};
  };
  void run(const Task& task);
  void take_pieces(int thread, std::uint32_t number);
  void serve(int thread);

  Task task_;                              ///< read only by who has taken a piece of it
  std::atomic<std::uint32_t> number_ = 0;  ///< of the present task, from 1
  std::atomic<int> undone_ = 0;            ///< pieces of it
  std::atomic<bool> over_ = false;
  std::unique_ptr<Share[]> shares_;  ///< (threads)
  std::vector<std::thread> others_;
};

}  // namespace blocks::dynamics
