// What a file is before it is read or replaced, and writing whole files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "files/file_error.hpp"

namespace blocks::files {

/// Throws FileError if `path` exists and is not a regular file, such as a link, a
/// folder, a device or a FIFO. Call it before a new file replaces the old one or
/// renames it.
void expect_replaceable(const std::string& path);

/// Throws FileError if `path`, or the target of its link, is a folder, a FIFO, a device
/// or a socket. Call it before a file is read to its end: a FIFO may have no writer and
/// a device no end. A missing file passes.
void expect_regular(const std::string& path);

/// Whether `path` is a regular file, not a link, and has this text at byte `at`.
bool has_text(const std::string& path, std::int64_t at, std::string_view text);

/// Throws FileError if `folder` is a link, so that files in it would be elsewhere.
void expect_no_link(const std::string& folder);

/// Renames an existing file to the first of PATH.bak, PATH.bak2, ... that is free.
/// Returns its ending, or an empty text if there is no file. Throws FileError if the
/// file is not a regular file or cannot be renamed.
std::string set_aside(const std::string& path);

/// Creates a new, empty file. If the name exists, even as a link to a missing file,
/// throws FileError and changes nothing.
void create_new_file(const std::string& path);

/// Creates the folder of `path` and the folders above it, if they are missing. Throws
/// FileError.
void create_folder_of(const std::string& path);

/// Moves a file, replacing its target. Throws FileError, also if either path is a
/// device, a FIFO or a folder.
void move_file(const std::string& from, const std::string& to);

/// A new file that gets its name when it is complete. All files that replace others are
/// written in this way, so existing files and links are neither written to nor removed.
/// The destructor removes the file unless it has got its name.
class TemporaryFile {
 public:
  /// Creates NAME.tmp, or NAME.tmp2 and so on if files of these names exist. Throws
  /// FileError if it cannot be created, or if `name` cannot be replaced.
  explicit TemporaryFile(const std::string& name);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }
  /// Renames the file to its name, replacing an existing file. Throws FileError.
  void take_name();
  /// The same, but an existing file gets the ending `aside` first. By default it is the
  /// first of .bak, .bak2, ... that is free, so nothing is lost; a file with the same
  /// content is replaced. Throws FileError.
  void take_name_keeping_older(const std::string& aside = {});

 private:
  std::string name_, path_;
};

/// Writes a file all at once: it has the old content or the new one at any moment.
/// Throws FileError.
void replace_file(const std::string& path, const std::string& content);
/// The same, but an older file with other content is kept as PATH.bak, PATH.bak2, ...
void replace_file_keeping_older(const std::string& path, const std::string& content);

/// Waits until the bytes of a file, or the entries of its folder, are on disk. Throws
/// FileError that names `meant`; `path` may be its temporary file.
void sync_file(const std::string& path, const std::string& meant);
void sync_folder_of(const std::string& path);

/// Whether both names mean the same existing file.
bool same_file(const std::string& a, const std::string& b);

}  // namespace blocks::files
