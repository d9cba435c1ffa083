// A file that appears only when it is complete.
#pragma once

#include <fstream>
#include <string>

#include "files/file_tools.hpp"

namespace blocks::files {

class WholeFile {
 public:
  /// Creates a temporary file. Without close(), it is removed. Throws
  /// FileError.
  explicit WholeFile(std::string path);

  WholeFile& operator<<(const std::string& text) {
    out_ << text;
    return *this;
  }
  /// Renames the file to PATH; an older one is kept as PATH.bak. Throws
  /// FileError, for example if the disk is full.
  void close();

 private:
  std::string path_;
  TemporaryFile temporary_;
  std::ofstream out_;
};

}  // namespace blocks::files
