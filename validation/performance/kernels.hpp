// Predicates and the contact law alone, by Google Benchmark.
#pragma once

#include <vector>

#include "report.hpp"

namespace blocks::bench {

/// Nanoseconds of one call of each, the median of so many repetitions of least this
/// long.
std::vector<Row> time_kernels(int rounds, double seconds);

}  // namespace blocks::bench
