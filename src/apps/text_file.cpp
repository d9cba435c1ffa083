#include "text_file.hpp"

#include <filesystem>

#include "output/file_tools.hpp"

namespace blocks::apps {

namespace fs = std::filesystem;

void write_text_file(const std::string& path, const std::string& text) {
  output::replace_file_keeping_older(path, text);
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::exists(a, ignored) && fs::exists(b, ignored) &&
         fs::equivalent(a, b, ignored);
}

}  // namespace blocks::apps
