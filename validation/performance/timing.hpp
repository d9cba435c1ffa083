// Times several codes in turns, so that the noise of a shared machine affects all of
// them equally.
#pragma once

#include <vector>

#include "contestant.hpp"

namespace blocks::bench {

/// Returns the seconds of one call. One thread is timed by processor time, because
/// other programs may share the processor. Several threads, and codes that are compared
/// with them, are timed by wall-clock time.
double seconds_of_run(Contestant& code, long steps);

double median(std::vector<double> values);

/// The times of the phases of a step.
struct Phases {
  double decisions = 0.0, forces = 0.0, motion = 0.0, search = 0.0;
};

/// The times of one code in each round, in nanoseconds per unit of work.
struct Times {
  long steps = 0;  ///< steps of a round
  std::vector<double> nanoseconds;

  double middle() const { return median(nanoseconds); }
};

/// The ratio of the second times to the first, from the pairs of each round.
struct Ratio {
  double middle = 0.0, min = 0.0, max = 0.0;
};
Ratio ratio(const Times& first, const Times& second);

/// Runs every code once in each round, forwards in even rounds and backwards in odd
/// ones. A turn of a code takes at least `seconds` and at least one step. rounds > 0.
std::vector<Times> take_turns(const std::vector<Contestant*>& codes, int rounds,
                              double seconds);

/// Does the same with `steps` steps in each turn, for costs that depend on the step.
std::vector<Times> take_equal_turns(const std::vector<Contestant*>& codes, int rounds,
                                    long steps);

}  // namespace blocks::bench
