// Are the numbers of joint sets recovered from the maps that the sets make?
#pragma once

#include <string>
#include <vector>

#include "validation/traces/maps.hpp"

namespace blocks::validation {

/// Two sets in a window of 40 x 30.
struct RecoveryCase {
  std::string name;
  std::vector<joints::testing::SetNumbers> sets;
};

/// A field of JSET.
struct RecoveredField {
  std::string name;
  int set = 1;
  double given = 0.0;
  double mean = 0.0;  ///< of the estimates
  int covered = 0;    ///< maps whose interval covers the given value
};

struct Recovery {
  int maps = 0;
  int right = 0;  ///< maps with as many families as sets; the others do not count
  int laws = 0;   ///< sets of these with the given law of spacing
  std::vector<RecoveredField> fields;
};

std::vector<RecoveryCase> recovery_cases();

/// Fits the sets to maps with the seeds from 1 on.
Recovery recover(const RecoveryCase& one, int maps);

}  // namespace blocks::validation
