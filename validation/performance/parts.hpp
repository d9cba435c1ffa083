// The parts of the benchmark; each adds its rows and targets to the report.
#pragma once

#include <string_view>
#include <vector>

#include "report.hpp"

namespace blocks::bench {

/// The extent of the benchmark.
struct Plan {
  int rounds = 5;
  double seconds = 0.2;  ///< minimum length of a turn of a code
  int smallest = 3;      ///< exponent: 10^3 blocks
  int largest = 6;
  int polygons = 1000;
  bool whole_decks = true;  ///< false: only their first tenth of a second
};

struct Part {
  std::string_view name, what;
  void (*run)(const Plan&, Report&);
  bool scenes = false;  ///< its rows are scenes in a state
};

/// Returns all parts in the order of the report.
const std::vector<Part>& parts();

/// Prints on standard error what is running.
void announce(const std::string& what);

void run_wall(const Plan& plan, Report& report);
void run_rock(const Plan& plan, Report& report);
void run_pile(const Plan& plan, Report& report);
void run_slope(const Plan& plan, Report& report);
void run_crater(const Plan& plan, Report& report);
void run_subsidence(const Plan& plan, Report& report);
void run_decks(const Plan& plan, Report& report);
void run_search(const Plan& plan, Report& report);
void run_predicates(const Plan& plan, Report& report);
void run_generation(const Plan& plan, Report& report);
void run_cut(const Plan& plan, Report& report);
void run_seeds(const Plan& plan, Report& report);
void run_sweeps(const Plan& plan, Report& report);

}  // namespace blocks::bench
