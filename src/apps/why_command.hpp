// `blocks why`: explains why two blocks touch, or do not, at one stored time.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

namespace blocks::apps {

struct WhyOptions {
  std::string file;                 ///< results or a checkpoint
  std::optional<std::string> time;  ///< the nearest frame is used; empty: the last one
  std::vector<std::string> blocks;  ///< two numbers, from 1
  bool json = false;
};

void add_why_options(CLI::App& command, WhyOptions& options);

/// Prints how the contacts of two blocks are decided. Returns a code of run::ExitCode.
/// For a time, a block or a pair that does not exist, it prints what exists and returns
/// usage_error.
int why(const WhyOptions& options);

}  // namespace blocks::apps
