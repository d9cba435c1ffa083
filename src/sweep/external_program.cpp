#include "sweep/external_program.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "run/support/shell_word.hpp"

namespace blocks::sweep {
namespace {

[[noreturn]] void fail(int reason, const std::string& name) {
  throw std::system_error(reason, std::generic_category(), "cannot call " + name);
}

int code_of(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

std::vector<char*> pointers_to(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (const std::string& word : words)
    pointers.push_back(const_cast<char*>(word.c_str()));  // execvp does not change them
  pointers.push_back(nullptr);
  return pointers;
}

/// The pipe from which the output of a program is read.
struct Pipe {
  std::array<int, 2> ends{-1, -1};
  explicit Pipe(const std::string& name) {
    if (::pipe(ends.data()) != 0)
      fail(errno, name);
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(std::size_t end) {
    if (ends[end] >= 0)
      ::close(ends[end]);
    ends[end] = -1;
  }
  std::string read_all() const {
    std::string text;
    std::array<char, 4096> part{};
    while (true) {
      const ssize_t size = ::read(ends[0], part.data(), part.size());
      if (size < 0 && errno == EINTR)
        continue;
      if (size <= 0)
        return text;
      text.append(part.data(), static_cast<std::size_t>(size));
    }
  }
};

}  // namespace

std::string find_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = (std::filesystem::path(folder) / name).string();
    if (::access(file.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(file))
      return file;
  }
  return {};
}

std::string this_program() {
  return std::filesystem::read_symlink("/proc/self/exe").string();
}

ProgramEnd call_program(const std::vector<std::string>& words, bool keep_output) {
  const std::vector<char*> arguments = pointers_to(words);
  Pipe pipe(words.front());
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  if (keep_output)
    ::posix_spawn_file_actions_adddup2(&actions, pipe.ends[1], STDOUT_FILENO);
  for (const int end : pipe.ends)
    ::posix_spawn_file_actions_addclose(&actions, end);
  std::fflush(nullptr);
  pid_t process = 0;
  const int fault = ::posix_spawnp(&process, arguments.front(), &actions, nullptr,
                                   arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (fault != 0)
    fail(fault, words.front());
  pipe.close_end(1);
  ProgramEnd end;
  end.output = pipe.read_all();
  while (!end.output.empty() && end.output.back() == '\n')
    end.output.pop_back();
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  end.code = code_of(status);
  return end;
}

ProgramProcess::ProgramProcess(const std::vector<std::string>& words) {
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const std::vector<char*> arguments = pointers_to(words);
  std::fflush(nullptr);
  const int fault = ::posix_spawnp(&process_, arguments.front(), nullptr, &attributes,
                                   arguments.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  if (fault != 0)
    fail(fault, words.front());
}

ProgramProcess::~ProgramProcess() {
  if (process_ < 0)
    return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

bool ProgramProcess::has_ended() {
  int status = 0;
  if (process_ > 0 && ::waitpid(process_, &status, WNOHANG) == process_) {
    process_ = -1;
    code_ = code_of(status);
  }
  return process_ < 0;
}

void ProgramProcess::send(int signal) const {
  if (process_ > 0)
    ::kill(process_, signal);
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words)
    line += (line.empty() ? "" : " ") + run::shell_word(word);
  return line;
}

}  // namespace blocks::sweep
