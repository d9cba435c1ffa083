// The results of a benchmark, as tables and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "timing.hpp"

namespace blocks::bench {

/// The cost of one code on one scene, per unit of work.
struct Row {
  std::string part, scene, code;
  int threads = 1;
  double blocks = 0;                ///< blocks that move; 0: not applicable
  std::string unit;                 ///< unit of work, such as "block-step"
  double cost = 0.0;                ///< nanoseconds, median
  std::optional<Ratio> ratio = {};  ///< cost of this code over that of `against`
  std::string against = {};
  std::string state = {};             ///< such as "calm"; empty if the scene has none
  std::optional<Phases> phases = {};  ///< nanoseconds; their sum is about the cost
};

/// A measured value and its limit.
struct Target {
  std::string what;
  double measured = 0.0, limit = 0.0;
  bool at_least = false;  ///< false: at most
  std::string unit = {};

  bool met() const { return at_least ? measured >= limit : measured <= limit; }
};

struct Report {
  bool quick = false;
  int rounds = 5;
  std::vector<Row> rows;
  std::vector<Target> targets;
  std::vector<std::string> notes;  ///< codes that were left out, and why

  /// Returns the row of this scene, state, code and number of threads, or null.
  const Row* find(const std::string& scene, const std::string& state,
                  const std::string& code, int threads = 1) const;
  /// Adds a note unless it is already present.
  void note(const std::string& text);
};

/// 10,000.
std::string grouped(long number);

/// Returns about three digits: "4.66", "64.4", "300".
std::string short_number(double value);

/// Returns "4.66 (3.93 to 5.32)", or nothing if there is no ratio.
std::string in_words(const std::optional<Ratio>& ratio);

/// Return Markdown tables: the heading and rows of a part, and the targets.
std::string table_of(const Report& report, const std::string& part);
std::string table_of_targets(const Report& report);

nlohmann::json to_json(const Report& report);

}  // namespace blocks::bench
