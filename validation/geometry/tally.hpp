// The counts of a run of `layers`, and the tables that it writes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace blocks::validation {

/// The counts of one generator for one family.
struct Tally {
  long layers = 0;
  long blocks = 0;
  long refused = 0;     ///< layers that were refused
  long failures = 0;    ///< layers that are no tilings, or should have been refused
  long judged = 0;      ///< layers that the independent judge examined too
  long judge_says = 0;  ///< judged layers that are no tilings according to the judge
  long disagree = 0;    ///< judged layers on which certificate and judge disagree
  std::vector<std::uint64_t> failed;  ///< numbers of the failures, for --replay

  void add(const Tally& other);
};

constexpr std::size_t generators = 3;  // Ours, naive, and naive with a crossing check.
using FamilyTally = std::array<Tally, generators>;

struct Run {
  long layers = 0;
  long every = 0;
  int threads = 0;
  double seconds = 0.0;
  std::vector<FamilyTally> families;
};

/// Return the failure table: as Markdown, and as JSON with the numbers of up to 200
/// failures of each kind.
std::string markdown(const Run& run);
std::string json(const Run& run);

}  // namespace blocks::validation
