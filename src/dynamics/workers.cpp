#include "dynamics/workers.hpp"

namespace blocks::dynamics {
namespace {

/// Looks at it for some microseconds, then lets others run, then sleeps: the phases of
/// a step follow each other faster than a thread wakes up, but cores may be few.
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

}  // namespace

Workers::Workers(int threads) {
  for (int part = 1; part < threads; ++part)
    others_.emplace_back([this, part] { serve(part); });
}

Workers::~Workers() {
  over_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& other : others_)
    other.join();
}

void Workers::start(const Task& task) {
  task_ = task;
  busy_.store(static_cast<int>(others_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
}

void Workers::finish() {
  wait_for(busy_, [](int left) { return left == 0; });
}

void Workers::serve(int part) {
  for (unsigned seen = 0;;) {
    seen = wait_for(round_, [&](unsigned now) { return now != seen; });
    if (over_)
      return;
    if (part < task_.parts)
      task_.call(task_.work, part, task_.parts, task_.count);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1)
      busy_.notify_one();
  }
}

}  // namespace blocks::dynamics
