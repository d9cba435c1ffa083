// A file that is open.
#pragma once

#include <utility>

namespace blocks::files {

/// A file descriptor that is closed by the destructor.
class OpenedFile {
 public:
  explicit OpenedFile(int descriptor = -1) : descriptor_(descriptor) {}
  OpenedFile(OpenedFile&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OpenedFile& operator=(OpenedFile&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;
  ~OpenedFile();
  int get() const { return descriptor_; }
  explicit operator bool() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

}  // namespace blocks::files
