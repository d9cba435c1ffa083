// Shared by the studies that run many steps of a deck without output: the command line,
// the step loop, the table of twenty rows and the report.
#pragma once

#include <cstdio>
#include <string>

#include "dynamics/step.hpp"
#include "model/model.hpp"

namespace blocks::long_run {

struct Study {
  std::string about;           ///< description for --help
  std::string deck;            ///< default deck, relative to the project folder
  long steps = 0;              ///< default of --steps
  std::string title, remark;   ///< heading and first paragraph of the report
  std::string columns, ruler;  ///< first two lines of the table, in Markdown
};

struct Verdict {
  std::string text;
  bool passed = false;
};

/// What a study measures during the run, and its verdict.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Called before the first step.
  virtual void start(const Model& model) = 0;
  /// Returns a row of the table, after step `step` = 1, 2, ...
  virtual std::string make_row(long step, const Model& model,
                               const dynamics::StepResult& result) = 0;
  /// Returns the verdict, after the last step.
  virtual Verdict judge(long steps, const Model& model) const = 0;
};

/// Number of rows of the table.
constexpr long row_count = 20;

/// Formats like printf into a string of at most 400 characters.
std::string format_text(const char* format, auto... values) {
  char line[400];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

/// Runs the whole program: reads --deck, --steps and --report, prints the table and
/// writes the report. Returns the exit code: 0 if the study passed, 4 if it did not or
/// a number is not finite, otherwise 2, 3 or 5 as `blocks` does.
int run(int argc, char** argv, const Study& study, Observer& observer);

}  // namespace blocks::long_run
