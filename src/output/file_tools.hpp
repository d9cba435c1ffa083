// Small helpers shared by the writers: names in messages, files replaced as a whole,
// and the hash over bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "output/file_in_hand.hpp"
#include "output/hdf5_handle.hpp"
#include "output/results.hpp"

namespace blocks::output {

/// Runs `action`; what HDF5 refuses becomes FileError "cannot write NAME: reason".
template <class Action>
auto naming(const char* verb, const std::string& path, Action&& action) {
  const FileInHand in_hand(verb, path);
  try {
    return action();
  } catch (const hdf5::Failure& failure) {
    throw FileError("cannot " + (verb + (" " + path)) + ": " + failure.what());
  }
}

/// "cannot write NAME: " and the words for errno.
[[noreturn]] void throw_errno(const char* verb, const std::string& path);

/// For files that take their name when they are whole: what stands there would be
/// replaced or moved aside. Throws FileError when it is neither a regular file nor
/// nothing: a folder, a device, a fifo.
void expect_replaceable(const std::string& path);

/// Moves a file, replacing its target. Throws FileError, also when one of the two is a
/// device, a fifo or a folder.
void move_file(const std::string& from, const std::string& to);

/// A file that does not have its name yet; removed unless it takes one.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }
  /// Replaces the file of that name. Throws FileError.
  void take_name(const std::string& name);

 private:
  std::string path_;
};

/// Waits until the file's bytes, or the folder's names, are on disk. Throws FileError
/// about the file `meant`, of which this one may be the temporary form.
void sync_file(const std::string& path, const std::string& meant);
void sync_folder_of(const std::string& path);

/// FNV-1a, 64 bits.
class Fnv1a {
 public:
  void add(const void* data, std::size_t size) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
      state_ = (state_ ^ byte[i]) * 0x100000001B3ULL;
  }
  std::uint64_t value() const { return state_; }
  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t state_ = 0xCBF29CE484222325ULL;
};

}  // namespace blocks::output
