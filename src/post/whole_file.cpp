#include "post/whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "output/file_tools.hpp"
#include "output/results.hpp"
#include "post/page_file.hpp"

namespace blocks::post {
namespace {

[[noreturn]] void cannot_write(const std::string& path) {
  throw output::FileError("cannot write " + path + ": " + std::strerror(errno));
}

}  // namespace

WholeFile::WholeFile(std::string path) : path_(std::move(path)) {
  output::expect_replaceable(path_);
  out_.open(path_ + ".tmp", std::ios::binary);
  if (!out_)
    cannot_write(path_);
}

WholeFile::~WholeFile() {
  if (out_.is_open()) {
    out_.close();
    std::remove((path_ + ".tmp").c_str());
  }
}

void WholeFile::close() {
  if (!out_.flush())
    cannot_write(path_);
  out_.close();
  take_name(path_ + ".tmp", path_);
}

}  // namespace blocks::post
