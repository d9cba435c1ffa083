// A library for LD_PRELOAD. The disk is full at the BLOCKS_FAIL_AT-th change of a file.
// That write takes half of its bytes. Later writes, fsync and rename fail. The file
// BLOCKS_COUNT has the number of changes.
#include <dlfcn.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace {

template <class Function> Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void count(long changes) {
  static std::FILE* file = std::fopen(std::getenv("BLOCKS_COUNT"), "w");
  std::rewind(file);
  std::fprintf(file, "%ld\n", changes);
  std::fflush(file);
}

/// Whether this change fails. For the write that takes half of its bytes, `size` is
/// halved.
bool fails(int file, std::size_t* size) {
  static const long fail_at = std::atol(std::getenv("BLOCKS_FAIL_AT"));
  static long changes = 0;
  static bool counting = false;
  if (file <= 2 || counting)
    return false;
  counting = true;
  count(++changes);
  counting = false;
  if (fail_at == 0 || changes < fail_at)
    return false;
  if (changes == fail_at && size != nullptr && *size > 1) {
    *size /= 2;
    return false;
  }
  errno = ENOSPC;
  return true;
}

}  // namespace

extern "C" {

ssize_t write(int file, const void* bytes, std::size_t size) {
  static auto* real = next<ssize_t(int, const void*, std::size_t)>("write");
  return fails(file, &size) ? -1 : real(file, bytes, size);
}

ssize_t writev(int file, const iovec* pieces, int count_of) {
  static auto* real = next<ssize_t(int, const iovec*, int)>("writev");
  return fails(file, nullptr) ? -1 : real(file, pieces, count_of);
}

ssize_t pwrite64(int file, const void* bytes, std::size_t size, off64_t offset) {
  static auto* real = next<ssize_t(int, const void*, std::size_t, off64_t)>("pwrite64");
  return fails(file, &size) ? -1 : real(file, bytes, size, offset);
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t offset) {
  return pwrite64(file, bytes, size, offset);
}

int fsync(int file) {
  static auto* real = next<int(int)>("fsync");
  return fails(file, nullptr) ? -1 : real(file);
}

int rename(const char* from, const char* to) {
  static auto* real = next<int(const char*, const char*)>("rename");
  return fails(3, nullptr) ? -1 : real(from, to);
}

}  // extern "C"
