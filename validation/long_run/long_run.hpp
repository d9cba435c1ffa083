// Many steps of a deck without output, looked at twenty times: command line, table and
// report of the studies that ask what becomes of it.
#pragma once

#include <cstdio>
#include <string>

#include "dynamics/step.hpp"
#include "model/model.hpp"

namespace blocks::long_run {

struct Study {
  std::string about;           ///< for --help
  std::string deck;            ///< its own, below the folder of the project
  long steps = 0;              ///< unless --steps says otherwise
  std::string title, remark;   ///< head of the report
  std::string columns, ruler;  ///< first two lines of the table, in Markdown
};

struct Verdict {
  std::string text;
  bool passed = false;
};

/// What a study keeps of the run and says of it.
class Watch {
 public:
  virtual ~Watch() = default;
  /// Before the first step.
  virtual void start(const Model& model) = 0;
  /// A row of the table, after step `step` = 1, 2, ...
  virtual std::string row(long step, const Model& model,
                          const dynamics::StepResult& made) = 0;
  virtual Verdict verdict(long steps, const Model& model) const = 0;
};

/// Rows of a table.
constexpr long rows = 20;

/// printf into a string of at most 400 characters.
std::string text(const char* format, auto... values) {
  char line[400];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

/// The whole program: options --deck, --steps, --report; prints the table and writes
/// the report. Returns the exit code: 0 passed, 4 not passed or a number that is not
/// finite, 2, 3, 5 as of the program.
int run(int argc, char** argv, const Study& study, Watch& watch);

}  // namespace blocks::long_run
