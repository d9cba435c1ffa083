// A library for LD_PRELOAD. It records every change of the results in the file
// BLOCKS_LOG, so that a test can repeat them one by one. A record has offset, size and
// bytes. The size is -1 for a truncation to the offset and -2 for a rename to the final
// name.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

template <class Function> Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool watched(int file) {
  char path[4096];
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  const ssize_t length = readlink(link.c_str(), path, sizeof path);
  return length > 0 &&
         std::string_view(path, static_cast<std::size_t>(length)).find(".vtkhdf") !=
             std::string_view::npos;
}

void note(std::int64_t offset, std::int64_t size, const void* bytes) {
  static std::FILE* log = std::fopen(std::getenv("BLOCKS_LOG"), "wb");
  std::fwrite(&offset, sizeof offset, 1, log);
  std::fwrite(&size, sizeof size, 1, log);
  if (size > 0)
    std::fwrite(bytes, 1, static_cast<std::size_t>(size), log);
  std::fflush(log);
}

}  // namespace

extern "C" {

ssize_t pwrite64(int file, const void* bytes, std::size_t size, off64_t offset) {
  static auto* real = next<ssize_t(int, const void*, std::size_t, off64_t)>("pwrite64");
  if (watched(file))
    note(offset, static_cast<std::int64_t>(size), bytes);
  return real(file, bytes, size, offset);
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t offset) {
  return pwrite64(file, bytes, size, offset);
}

int ftruncate64(int file, off64_t length) {
  static auto* real = next<int(int, off64_t)>("ftruncate64");
  if (watched(file))
    note(length, -1, nullptr);
  return real(file, length);
}

int ftruncate(int file, off_t length) { return ftruncate64(file, length); }

int rename(const char* from, const char* to) {
  static auto* real = next<int(const char*, const char*)>("rename");
  if (std::string_view(to).ends_with(".vtkhdf"))
    note(0, -2, nullptr);
  return real(from, to);
}

}  // extern "C"
