// Helpers shared by the writers: file names in messages, replacing whole files, and a
// hash over bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "output/file_access_guard.hpp"
#include "output/hdf5_handle.hpp"
#include "output/results.hpp"

namespace blocks::output {

/// Runs `action` and converts hdf5::Failure to FileError: "cannot write NAME: reason".
template <class Action>
auto with_file_errors(const char* verb, const std::string& path, Action&& action) {
  const FileAccessGuard in_hand(verb, path);
  try {
    return action();
  } catch (const hdf5::Failure& failure) {
    throw FileError("cannot " + (verb + (" " + path)) + ": " + failure.what());
  }
}

/// Throws FileError: "cannot write NAME: " and the message of errno.
[[noreturn]] void throw_errno(const char* verb, const std::string& path);

/// Throws FileError if `path` exists and is not a regular file, such as a folder, a
/// device or a FIFO. Call it before a new file replaces the old one or renames it.
void expect_replaceable(const std::string& path);

/// Creates the folder of `path` and the folders above it, if they are missing. Throws
/// FileError.
void create_folder_of(const std::string& path);

/// Moves a file, replacing its target. Throws FileError, also if either path is a
/// device, a FIFO or a folder.
void move_file(const std::string& from, const std::string& to);

/// A file with a temporary name. The destructor removes it unless take_name() was
/// called.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }
  /// Renames the file to `name`, replacing an existing file. Throws FileError.
  void take_name(const std::string& name);

 private:
  std::string path_;
};

/// Writes a file all at once: it has the old content or the new one at any moment.
/// Throws FileError.
void replace_file(const std::string& path, const std::string& content);

/// Waits until the bytes of a file, or the entries of its folder, are on disk. Throws
/// FileError that names `meant`; `path` may be its temporary file.
void sync_file(const std::string& path, const std::string& meant);
void sync_folder_of(const std::string& path);

/// The FNV-1a hash, 64 bits.
class Fnv1a {
 public:
  void add(const void* data, std::size_t size) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
      state_ = (state_ ^ byte[i]) * 0x100000001B3ULL;
  }
  std::uint64_t value() const { return state_; }
  /// The hash as 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t state_ = 0xCBF29CE484222325ULL;
};

}  // namespace blocks::output
