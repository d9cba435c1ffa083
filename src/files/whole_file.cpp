#include "files/whole_file.hpp"

#include <utility>

namespace blocks::files {
WholeFile::WholeFile(std::string path)
    : path_(std::move(path)), temporary_(path_),
      out_(temporary_.path(), std::ios::binary) {
  if (!out_)
    throw_errno("write", path_);
}

void WholeFile::close() {
  if (!out_.flush())
    throw_errno("write", path_);
  out_.close();
  temporary_.take_name_keeping_older();
}

}  // namespace blocks::files
