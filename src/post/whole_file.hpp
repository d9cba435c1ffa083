// A file that appears only when it is complete.
#pragma once

#include <fstream>
#include <string>

namespace blocks::post {

class WholeFile {
 public:
  /// Creates PATH.tmp. Throws output::FileError.
  explicit WholeFile(std::string path);
  /// Removes the file unless close() was called.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  WholeFile& operator<<(const std::string& text) {
    out_ << text;
    return *this;
  }
  /// Renames the file to PATH; an older one is kept as PATH.bak. Throws
  /// output::FileError, for example if the disk is full.
  void close();

 private:
  std::string path_;
  std::ofstream out_;
};

}  // namespace blocks::post
