// Times predicates and the contact law alone, with Google Benchmark.
#pragma once

#include <vector>

#include "report.hpp"

namespace blocks::bench {

/// Returns a row for each: nanoseconds per call, the median of `rounds` repetitions of
/// at least `seconds`.
std::vector<Row> time_kernels(int rounds, double seconds);

}  // namespace blocks::bench
