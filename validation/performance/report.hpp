// What a benchmark found: rows for the terminal, JSON and a chart.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "timing.hpp"

namespace blocks::bench {

/// One code on one scene. Cost is of one unit of work.
struct Row {
  std::string part, scene, code;
  int threads = 1;
  double blocks = 0;                ///< that move; 0: not about blocks
  std::string unit;                 ///< of work: "block-step"
  double cost = 0.0;                ///< nanoseconds, median
  std::optional<Ratio> ratio = {};  ///< this code's cost over that of `against`
  std::string against = {};
};

/// What was to be reached.
struct Target {
  std::string what;
  double measured = 0.0, limit = 0.0;
  bool at_least = false;  ///< else: at most
  std::string unit = {};

  bool met() const { return at_least ? measured >= limit : measured <= limit; }
};

struct Report {
  bool quick = false;
  int rounds = 5;
  std::vector<Row> rows;
  std::vector<Target> targets;
  std::vector<std::string> notes;  ///< what was left out, and why

  /// The row of this part, scene and code, or null.
  const Row* find(const std::string& part, const std::string& scene,
                  const std::string& code) const;
};

/// 10,000.
std::string grouped(long number);

/// Tables of Markdown: a part's heading and rows; the targets.
std::string table_of(const Report& report, const std::string& part);
std::string table_of_targets(const Report& report);

nlohmann::json to_json(const Report& report);

/// Cost of a block-step of the wall against blocks, a line for each code and number of
/// threads, and what each costs over the program. False: fewer than two sizes were run.
bool draw(const Report& report, const std::string& path);

}  // namespace blocks::bench
