// `blocks why`: why two blocks touch, or do not, at one stored time.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

namespace blocks::apps {

struct WhyOptions {
  std::string file;                 ///< results or a checkpoint
  std::optional<std::string> time;  ///< the frame nearest to it; else the last
  std::vector<std::string> blocks;  ///< two numbers, from 1
  bool json = false;
};

void add_why_options(CLI::App& command, WhyOptions& options);

/// Prints the story of two blocks. Returns an exit code of run::ExitCode:
/// usage_error, with what there is, for a time, a block or a pair that is not there.
int why(const WhyOptions& options);

}  // namespace blocks::apps
