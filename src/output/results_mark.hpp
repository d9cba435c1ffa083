// The mark at the head of a results file, 512 bytes of text that HDF5 leaves alone (its
// user block): how often the file was changed, odd while a change is under way. Whoever
// reads beside the run compares the numbers before and after and reads again. Knows
// bytes and a lock, nothing of HDF5.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace blocks::output {

constexpr std::size_t mark_size = 512;
constexpr std::string_view results_head = "BLOCKS r";  ///< the first 8 bytes

/// A descriptor that closes itself.
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

/// The writer's side. The file is locked (advisory) while this lives, which tells a
/// change under way from one whose writer died.
class ChangeMark {
 public:
  ChangeMark() = default;
  /// Of a new file: writes the mark. Throws hdf5::Failure.
  static ChangeMark make(const std::string& path);
  /// Of an older one, which may have no mark and then gets none. Throws hdf5::Failure.
  static ChangeMark find(const std::string& path);
  ChangeMark(ChangeMark&&) noexcept = default;
  ChangeMark& operator=(ChangeMark&&) noexcept = default;
  /// Whatever was written until now stays.
  ~ChangeMark();

  /// Before the first byte changes: odd. Once more changes nothing. Throws
  /// hdf5::Failure.
  void begin();
  /// Behind the last one: even. Throws hdf5::Failure.
  void end();

 private:
  ChangeMark(const std::string& path, bool is_new);
  void write(std::uint64_t number);
  OpenedFile file_;
  std::uint64_t number_ = 0;
};

/// Whether a writer holds the file, which a run does to its end. Where there are no
/// locks: false.
bool is_being_written(const std::string& path);

/// The reader's side.
class ChangeWatch {
 public:
  /// A file that cannot be opened or has no mark counts as one that never changes.
  explicit ChangeWatch(const std::string& path);

  /// How often the file was changed; 0 without a mark.
  std::uint64_t number() const;
  /// The number once no change is under way, or one that nobody will end; nothing when
  /// `until` comes first.
  std::optional<std::uint64_t>
  settled(std::chrono::steady_clock::time_point until) const;
  /// Is the file still the one of that name?
  bool still_named(const std::string& path) const;

 private:
  OpenedFile file_;
};

}  // namespace blocks::output
