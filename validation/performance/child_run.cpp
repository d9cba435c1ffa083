#include "child_run.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

namespace blocks::bench {

RunCost run_child(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0)
      dup2(nowhere, STDOUT_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (child < 0 || wait4(child, &status, 0, &used) < 0 || status != 0) {
    std::string line;
    for (const std::string& word : words)
      line += (line.empty() ? "" : " ") + word;
    throw std::runtime_error("this run failed: " + line);
  }
  const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - start;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {.user = seconds(used.ru_utime),
          .system = seconds(used.ru_stime),
          .clock = clock.count(),
          .memory = 1024.0 * static_cast<double>(used.ru_maxrss)};
}

}  // namespace blocks::bench
