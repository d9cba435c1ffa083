#include "text_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "output/results.hpp"

namespace blocks::apps {

namespace fs = std::filesystem;

void write_text_file(const std::string& path, const std::string& text) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored))
    fs::rename(path, path + ".bak",
               ignored);  // an error appears again when the file is written
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out)
    throw output::FileError("cannot write " + path + ": " + std::strerror(errno));
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::exists(a, ignored) && fs::exists(b, ignored) &&
         fs::equivalent(a, b, ignored);
}

}  // namespace blocks::apps
