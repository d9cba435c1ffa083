#include "fault.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "files/file_error.hpp"
#include "run/run.hpp"

namespace blocks::apps {

int tell_fault(const std::runtime_error& error) {
  fmt::print(stderr, "blocks: error: {}\n", error.what());
  const bool of_a_file = dynamic_cast<const files::FileError*>(&error) != nullptr;
  return of_a_file ? run::file_error : run::usage_error;
}

}  // namespace blocks::apps
