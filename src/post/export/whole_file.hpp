// A file that appears only when it is complete.
#pragma once

#include <fstream>
#include <string>

#include "output/file_tools.hpp"

namespace blocks::post {

class WholeFile {
 public:
  /// Creates a temporary file. Without close(), it is removed. Throws
  /// output::FileError.
  explicit WholeFile(std::string path);

  WholeFile& operator<<(const std::string& text) {
    out_ << text;
    return *this;
  }
  /// Renames the file to PATH; an older one is kept as PATH.bak. Throws
  /// output::FileError, for example if the disk is full.
  void close();

 private:
  std::string path_;
  output::TemporaryFile temporary_;
  std::ofstream out_;
};

}  // namespace blocks::post
