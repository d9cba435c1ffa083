// Times the cutting of a domain by random traces, and measures its memory.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "child_run.hpp"
#include "parts.hpp"

namespace blocks::bench {

void run_cut(const Plan& plan, Report& report) {
  const std::vector<long> sizes =
      plan.largest < 5 ? std::vector<long>{1000, 10'000}
                       : std::vector<long>{1000, 10'000, 100'000, 300'000};
  std::vector<double> costs;  // seconds for each trace
  for (const long traces : sizes) {
    announce("cut, " + grouped(traces) + " traces");
    std::vector<double> seconds, megabytes;
    const int repetitions = traces > 10'000 ? std::min(plan.rounds, 3) : plan.rounds;
    for (int i = 0; i < repetitions; ++i) {
      const RunCost cost = run_child({BLOCKS_CUT_TRACES, std::to_string(traces)});
      seconds.push_back(cost.user + cost.system);
      megabytes.push_back(1e-6 * cost.memory);
    }
    costs.push_back(median(seconds) / static_cast<double>(traces));
    report.rows.push_back({"cut", grouped(traces) + " traces",
                           fmt::format("{} s, {} MB", short_number(median(seconds)),
                                       short_number(median(megabytes))),
                           1, static_cast<double>(traces), "trace",
                           1e9 * costs.back()});
    if (traces == 100'000) {
      report.targets.push_back(
          {"100,000 traces cut and certified", median(seconds), 10, false, " s"});
      report.targets.push_back({"100,000 traces cut and certified, memory",
                                median(megabytes), 1000, false, " MB"});
    }
  }
  if (sizes.size() == 4)
    report.targets.push_back({"a trace of 300,000, over one of 10,000",
                              costs.back() / costs[1], 1.5, false});
}

}  // namespace blocks::bench
