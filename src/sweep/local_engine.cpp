#include "sweep/local_engine.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <deque>
#include <list>
#include <thread>
#include <vector>

#include "run/run.hpp"
#include "sweep/outcome.hpp"
#include "sweep/progress.hpp"
#include "sweep/signal_watch.hpp"
#include "sweep/worker.hpp"

namespace blocks::sweep {
namespace {

/// Whether the program itself is to blame for a signal that ended it.
bool is_crash(int signal) {
  constexpr int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP};
  return std::find(std::begin(crashes), std::end(crashes), signal) != std::end(crashes);
}

class LocalEngine {
 public:
  LocalEngine(const std::string& folder, const Plan& plan,
              const std::vector<std::size_t>& ids, const LocalChoice& choice)
      : folder_(folder), plan_(plan), choice_(choice), queue_(ids.begin(), ids.end()),
        progress_(choice.all - ids.size(), choice.all, choice.quiet),
        finished_(choice.all - ids.size()) {}

  LocalResult run() {
    while (true) {
      pass_on_signals();
      start_workers();
      if (workers_.empty() && !take_over())
        break;
      wait();
      if (progress_.is_due())
        progress_.show(
            finished_,
            fmt::format("{}, {} running",
                        failed_ > 0 ? fmt::format(", {} failed", failed_) : "",
                        std::count_if(workers_.begin(), workers_.end(),
                                      [](const Worker& worker) {
                                        return !worker.open().empty();
                                      })));
    }
    progress_.clear();
    result_.elsewhere = elsewhere_.size();
    result_.signal = signals_.signal();
    return result_;
  }

 private:
  bool stops() const {
    return signals_.signal() != 0 || result_.not_written.has_value();
  }

  /// Short runs share a process, because starting one costs more than they do.
  std::size_t runs_per_worker() const {
    if (plan_.kind == Kind::run)
      return 1;
    const std::size_t max = 64, shares = 4 * static_cast<std::size_t>(choice_.jobs);
    return std::clamp<std::size_t>(queue_.size() / shares, 1, max);
  }

  void start_workers() {
    while (!stops() && !queue_.empty() &&
           workers_.size() < static_cast<std::size_t>(choice_.jobs)) {
      const auto end = queue_.begin() + static_cast<std::ptrdiff_t>(runs_per_worker());
      workers_.emplace_back(folder_, plan_,
                            std::vector<std::size_t>(queue_.begin(), end), choice_.run);
      queue_.erase(queue_.begin(), end);
    }
  }

  void pass_on_signals() {
    const SignalWatch::Asked request = signals_.asked();
    if (request == SignalWatch::Asked::nothing)
      return;
    for (const Worker& worker : workers_)
      worker.send(request == SignalWatch::Asked::stop ? SIGTERM : SIGKILL);
  }

  /// Waits until a run has ended, a signal has come, or the progress line is due.
  void wait() {
    std::vector<pollfd> ends;
    for (const Worker& worker : workers_)
      ends.push_back({worker.descriptor(), POLLIN, 0});
    constexpr int milliseconds = 200;
    if (::poll(ends.data(), ends.size(), milliseconds) <= 0)
      return;
    auto worker = workers_.begin();
    for (const pollfd& end : ends) {
      const auto here = worker++;
      if (end.revents == 0)
        continue;
      const std::size_t id = here->open().empty() ? 0 : here->open().front();
      if (const auto ended = here->next_end()) {
        note(id, *ended);
      } else {
        take_back(*here);
        workers_.erase(here);
      }
    }
  }

  void note(std::size_t id, const RunEnd& end) {
    using What = RunEnd::What;
    if (end.what == What::finished) {
      ++finished_;
      failed_ += end.code == run::done ? 0 : 1;
    } else if (end.what == What::elsewhere) {
      if (has_outcome(run_folder(folder_, id)))
        ++finished_;
      else
        elsewhere_.push_back(id);
    } else if (end.what == What::not_written && !result_.not_written) {
      result_.not_written = id;
      result_.message = end.message;
    }
  }

  /// Tries the runs again that were at work elsewhere. They may belong to a killed
  /// sweep and stop at their next checkpoint. Returns false if there are none, or they
  /// have been tried for some seconds.
  bool take_over() {
    using namespace std::chrono_literals;
    constexpr auto pause = 100ms;
    constexpr int max_tries = 100;
    if (stops() || elsewhere_.empty() || ++tries_ > max_tries)
      return false;
    std::this_thread::sleep_for(pause);
    queue_.assign(elsewhere_.begin(), elsewhere_.end());
    elsewhere_.clear();
    return true;
  }

  /// Takes back the runs that a process has not reported at its end. The first of them,
  /// at which it ended, is not given to another process.
  void take_back(Worker& worker) {
    const int signal = worker.signal();
    const std::deque<std::size_t>& open = worker.open();
    if (open.empty())
      return;
    if (is_crash(signal)) {
      write_crash(folder_, open.front(), signal);
      ++finished_;
      ++failed_;
    } else {
      ++result_.killed;
    }
    queue_.insert(queue_.begin(), open.begin() + 1, open.end());
  }

  const std::string& folder_;
  const Plan& plan_;
  const LocalChoice& choice_;
  std::deque<std::size_t> queue_;
  std::vector<std::size_t> elsewhere_;  ///< runs at work in other processes
  int tries_ = 0;                       ///< of take_over()
  std::list<Worker> workers_;
  Progress progress_;
  std::size_t finished_, failed_ = 0;
  SignalWatch signals_;
  LocalResult result_;
};

}  // namespace

LocalResult run_local(const std::string& folder, const Plan& plan,
                      const std::vector<std::size_t>& ids, const LocalChoice& choice) {
  return LocalEngine(folder, plan, ids, choice).run();
}

}  // namespace blocks::sweep
