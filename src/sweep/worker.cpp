#include "sweep/worker.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <system_error>
#include <utility>

#include "run/run.hpp"
#include "run/support/interrupt.hpp"

namespace blocks::sweep {
namespace {

/// A RunEnd on its way through the pipe. Small enough to be written at once.
struct Report {
  RunEnd::What what;
  int code;
  std::array<char, 240> message;  ///< ends with 0
};

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Sends a report to the parent. Returns false if the parent has ended.
bool send_report(int pipe, const RunEnd& end) {
  Report report{end.what, end.code, {}};
  end.message.copy(report.message.data(), report.message.size() - 1);
  return ::write(pipe, &report, sizeof report) == static_cast<ssize_t>(sizeof report);
}

/// The work of the new process. Nothing is thrown to its caller, which has the objects
/// of the parent.
[[noreturn]] void work(const std::string& folder, const Plan& plan,
                       const std::deque<std::size_t>& ids, const RunChoice& choice,
                       int pipe, pid_t parent) {
  ::setpgid(0, 0);  // Ctrl-C reaches the parent alone, which passes it on once
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  std::signal(SIGPIPE, SIG_IGN);
  if (::getppid() != parent)
    ::_exit(0);
  try {
    for (const std::size_t id : ids)
      if (run::interrupt_requested() ||
          !send_report(pipe, run_once(folder, plan, id, choice)))
        break;
  } catch (const std::exception& fault) {
    send_report(pipe, {RunEnd::What::not_written, run::file_error, fault.what()});
  }
  std::cout.flush();
  std::fflush(nullptr);
  ::_exit(0);  // without the ends of the objects of the parent
}

/// Keeps SIGINT, SIGTERM and SIGHUP waiting as long as it exists.
class HeldSignals {
 public:
  HeldSignals() {
    sigset_t held;
    ::sigemptyset(&held);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
      ::sigaddset(&held, signal);
    ::sigprocmask(SIG_BLOCK, &held, &before_);
  }
  ~HeldSignals() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  void release_in_child() const {
    run::catch_interrupts();
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t before_{};
};

}  // namespace

Worker::Worker(const std::string& folder, const Plan& plan,
               std::vector<std::size_t> ids, const RunChoice& choice)
    : open_(ids.begin(), ids.end()) {
  int ends[2];
  if (::pipe(ends) != 0)
    fail("cannot start a run");
  std::cout.flush();
  std::fflush(nullptr);  // the child has a copy of what is not written yet
  const pid_t parent = ::getpid();
  // A signal between the fork and the handlers of the child would be lost.
  const HeldSignals held;
  process_ = ::fork();
  if (process_ < 0)
    fail("cannot start a run");
  if (process_ == 0) {
    ::close(ends[0]);
    held.release_in_child();
    work(folder, plan, open_, choice, ends[1], parent);
  }
  ::close(ends[1]);
  pipe_ = ends[0];
}

Worker::Worker(Worker&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      pipe_(std::exchange(other.pipe_, -1)), open_(std::move(other.open_)) {}

Worker::~Worker() {
  if (pipe_ >= 0)
    ::close(pipe_);
  if (process_ < 0)
    return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

std::optional<RunEnd> Worker::next_end() {
  Report report{};
  ssize_t size = 0;
  do
    size = ::read(pipe_, &report, sizeof report);
  while (size < 0 && errno == EINTR);
  if (size != static_cast<ssize_t>(sizeof report))
    return std::nullopt;
  open_.pop_front();
  return RunEnd{report.what, report.code, report.message.data()};
}

int Worker::signal() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

void Worker::send(int signal) const { ::kill(process_, signal); }

}  // namespace blocks::sweep
