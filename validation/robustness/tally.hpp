// What a run of robustness counts, and the tables it writes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace blocks::robustness {

/// One generator on one family.
struct Tally {
  long layers = 0;
  long blocks = 0;
  long refused = 0;     ///< no layer was made
  long failures = 0;    ///< made, and not a tiling (or made where none is possible)
  long judged = 0;      ///< layers the independent judge saw as well
  long judge_says = 0;  ///< of these, not a tiling by the judge
  long disagree = 0;    ///< certificate and judge of different opinion
  std::vector<std::uint64_t> failed;  ///< their numbers, for --replay

  void add(const Tally& other);
};

constexpr std::size_t generators = 3;  // ours, naive, naive with a crossing check
using FamilyTally = std::array<Tally, generators>;

struct Run {
  long layers = 0;
  long every = 0;
  int threads = 0;
  double seconds = 0.0;
  std::vector<FamilyTally> families;
};

/// The failure table. Markdown for the reader, JSON with the numbers of up to 200
/// failures of each kind.
std::string markdown(const Run& run);
std::string json(const Run& run);

}  // namespace blocks::robustness
