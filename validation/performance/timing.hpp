// Times of several codes taken in turn, so that the noise of a shared machine hits all
// of them alike.
#pragma once

#include <vector>

#include "contestant.hpp"

namespace blocks::bench {

/// Seconds of one call. One thread: of the processor, for other programs may share
/// it; more, and what is compared with them: of the clock on the wall.
double seconds_of_run(Contestant& code, long steps);

double median(std::vector<double> values);

/// These are the times of the phases of a step.
struct Phases {
  double decisions = 0.0, forces = 0.0, motion = 0.0, search = 0.0;
};

/// What one code took, round by round, in nanoseconds for each unit of work.
struct Times {
  long steps = 0;  ///< of a round
  std::vector<double> nanoseconds;

  double middle() const { return median(nanoseconds); }
};

/// How often the second takes as long as the first, of the pairs of one round each.
struct Ratio {
  double middle = 0.0, least = 0.0, most = 0.0;
};
Ratio ratio(const Times& first, const Times& second);

/// Runs every code once in every round, forwards in even rounds and backwards in odd
/// ones. rounds > 0; seconds: least length of a code's turn; one step at least.
std::vector<Times> take_turns(const std::vector<Contestant*>& codes, int rounds,
                              double seconds);

/// The same with so many steps in every turn: for costs that depend on the step.
std::vector<Times> take_equal_turns(const std::vector<Contestant*>& codes, int rounds,
                                    long steps);

}  // namespace blocks::bench
