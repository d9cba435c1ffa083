#include "files/file_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

namespace blocks::files {

void throw_errno(const char* verb, const std::string& path) {
  throw FileError(fmt::format("cannot {} {}: {}", verb, path,
                              std::generic_category().message(errno)));
}

}  // namespace blocks::files
