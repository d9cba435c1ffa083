#include "files/fnv1a.hpp"

#include <fmt/format.h>

namespace blocks::files {

std::string Fnv1a::text() const { return fmt::format("{:016x}", state_); }

}  // namespace blocks::files
