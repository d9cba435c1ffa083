// Replaces libFuzzer in the normal build. It tries every file of the given folders and
// then MUTANTS mutants of them, which are the same in every run.
//   fuzz_NAME [--children] MUTANTS FOLDER...
// An input that crashes the program is stored as crash.fuzz_NAME in the current folder.
// With --children every input has its own process. A crash inside HDF5 that the program
// reports (files/file_access_guard.hpp) is counted and is no failure.
#include <algorithm>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "files/file_access_guard.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::string input, crash_name;

void keep_input() {
  if (std::FILE* file = std::fopen(crash_name.c_str(), "wb")) {
    std::fwrite(input.data(), 1, input.size(), file);
    std::fclose(file);
  }
}

void crashed(int signal) {
  keep_input();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void try_input() {
  try {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()),
                           input.size());
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    std::abort();
  }
}

bool children = false;
long reported = 0;  ///< crashes inside HDF5

void try_apart() {
  if (!children)
    return try_input();
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    if (std::freopen("/dev/null", "w", stderr) == nullptr)
      _exit(1);
    blocks::files::tell_crashes_of_files(5);
    try_input();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 5)
    ++reported;
  else if (status != 0)
    crashed(WIFSIGNALED(status) ? WTERMSIG(status) : SIGABRT);
}

class Mutator {
 public:
  explicit Mutator(const std::vector<std::string>& corpus) : corpus_(corpus) {}

  std::string operator()() {
    std::string bytes = corpus_[below(corpus_.size())];
    for (std::size_t n = 1 + below(4); n > 0; --n)
      change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  /// Returns a random place, rarely within the padding of binary files.
  std::size_t place(const std::string& bytes) {
    std::size_t at = below(bytes.size() + 1);
    for (int again = 0; again < 9 && at < bytes.size() && bytes[at] == 0; ++again)
      at = below(bytes.size());
    return at;
  }
  void change(std::string& bytes) {
    const std::size_t at = place(bytes);
    const std::size_t length = 1 + below(8);
    switch (below(6)) {
    case 0:
      if (at < bytes.size())
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      break;
    case 1:
      if (at < bytes.size())
        bytes[at] = static_cast<char>(below(256));
      break;
    case 2:
      bytes.erase(at, length);
      break;
    case 3:
      bytes.insert(at, length, static_cast<char>(below(256)));
      break;
    case 4: {
      static const char* const words[] = {
          "-1", "0",    "1e308", "nan", "2147483648",      ",",
          "\n", "1e-5", "(",     "]",   "\xff\xff\xff\xff"};
      bytes.insert(at, words[below(std::size(words))]);
      break;
    }
    default: {
      const std::string& other = corpus_[below(corpus_.size())];
      bytes.replace(at, 8 * length, other, below(other.size()), 8 * length);
    }
    }
  }

  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_{1982};
};

}  // namespace

int main(int argc, char** argv) {
  crash_name = "crash." + std::filesystem::path(argv[0]).filename().string();
  if (argc > 1 && std::string(argv[1]) == "--children") {
    children = true;
    --argc;
    ++argv;
  }
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s [--children] MUTANTS FOLDER...\n",
                 crash_name.c_str() + 6);
    return 2;
  }
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL})
    std::signal(signal, crashed);
  std::vector<std::filesystem::path> files;
  for (int i = 2; i < argc; ++i)
    for (const auto& file : std::filesystem::recursive_directory_iterator(argv[i]))
      if (file.is_regular_file())
        files.push_back(file.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> corpus;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    corpus.push_back(input = {std::istreambuf_iterator<char>(in), {}});
    try_apart();
  }
  if (corpus.empty()) {
    std::fprintf(stderr, "%s: no inputs\n", crash_name.c_str() + 6);
    return 1;
  }
  Mutator mutant(corpus);
  const long mutants = std::atol(argv[1]);
  for (long i = 0; i < mutants; ++i) {
    input = mutant();
    try_apart();
  }
  std::printf("%zu inputs, %ld mutants", corpus.size(), mutants);
  if (children)
    std::printf(", %ld of them told as files in which HDF5 fails", reported);
  std::printf("\n");
}
