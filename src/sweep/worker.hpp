// A process that runs some runs of a sweep, one after the other.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "sweep/one_run.hpp"
#include "sweep/plan.hpp"

namespace blocks::sweep {

class Worker {
 public:
  /// Starts the process. If its parent dies, it ends at a checkpoint. Throws
  /// std::system_error.
  Worker(const std::string& folder, const Plan& plan, std::vector<std::size_t> ids,
         const RunChoice& choice);
  Worker(Worker&& other) noexcept;
  Worker& operator=(Worker&&) = delete;
  /// Kills the process if it is still there.
  ~Worker();

  /// Readable when a run has ended or the process has.
  int descriptor() const { return pipe_; }
  /// The runs that it has not reported, the present one first.
  const std::deque<std::size_t>& open() const { return open_; }
  /// Returns the end of the next run that has ended, or nothing when the process itself
  /// has ended. Waits for either.
  std::optional<RunEnd> next_end();
  /// Returns the signal that ended the process, or 0. Call it after next_end() has
  /// returned nothing.
  int signal();
  void send(int signal) const;

 private:
  pid_t process_ = -1;
  int pipe_ = -1;
  std::deque<std::size_t> open_;
};

}  // namespace blocks::sweep
