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

ProgramEnd call_program(const std::vector<std::string>& words) {
  std::fflush(nullptr);
  std::FILE* const pipe = ::popen(shell_line(words).c_str(), "r");
  if (pipe == nullptr)
    fail(errno, words.front());
  ProgramEnd end;
  std::array<char, 4096> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe))
    end.output.append(part.data(), size);
  while (!end.output.empty() && end.output.back() == '\n')
    end.output.pop_back();
  end.code = code_of(::pclose(pipe));
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
