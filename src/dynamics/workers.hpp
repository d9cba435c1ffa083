// Threads that share the work of a step. Which thread does what never shows in a
// result: every item is computed on its own, and sums are taken in a fixed order.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace blocks::dynamics {

/// Items of a step below which a second thread does not pay.
inline constexpr int pairs_per_thread = 256, sets_per_thread = 128,
                     blocks_per_thread = 128;

class Workers {
 public:
  /// This many threads, the calling one among them; at least 1.
  explicit Workers(int threads = 1);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const { return static_cast<int>(others_.size()) + 1; }

  /// Splits 0 .. count - 1 into as many ranges as there are threads, or fewer so that
  /// none but the last is shorter than `least`, and calls work(part, first, last) for
  /// each at the same time. Returns when all are done. `work` must not throw, and not
  /// call each(). Allocates nothing.
  template <class Work> void each(int count, int least, const Work& work) {
    const int parts = std::max(1, std::min(threads(), count / std::max(1, least)));
    if (parts == 1) {
      work(0, 0, count);
      return;
    }
    const auto call = [](const void* what, int part, int all, int n) {
      const auto at = [&](int p) {
        return static_cast<int>(static_cast<long>(n) * p / all);
      };
      (*static_cast<const Work*>(what))(part, at(part), at(part + 1));
    };
    start({call, &work, parts, count});
    call(&work, 0, parts, count);
    finish();
  }

 private:
  struct Task {
    void (*call)(const void*, int, int, int) = nullptr;
    const void* work = nullptr;
    int parts = 0, count = 0;
  };
  void start(const Task& task);
  void finish();
  void serve(int part);

  Task task_;
  std::atomic<unsigned> round_ = 0;  ///< tasks given so far
  std::atomic<int> busy_ = 0;        ///< parts of the present task not done
  std::atomic<bool> over_ = false;
  std::vector<std::thread> others_;
};

}  // namespace blocks::dynamics
