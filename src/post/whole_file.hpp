// A file that appears whole or not at all.
#pragma once

#include <fstream>
#include <string>

namespace blocks::post {

class WholeFile {
 public:
  /// Writes PATH.tmp. Throws output::FileError.
  explicit WholeFile(std::string path);
  /// Without close() nothing is left.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  WholeFile& operator<<(const std::string& text) {
    out_ << text;
    return *this;
  }
  /// The file takes its name, an older one is kept as PATH.bak. Throws
  /// output::FileError: disk full.
  void close();

 private:
  std::string path_;
  std::ofstream out_;
};

}  // namespace blocks::post
