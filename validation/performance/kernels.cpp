#include "kernels.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>

#include "dynamics/kernels/contact_law.hpp"
#include "geometry/contact_predicates.hpp"
#include "geometry/random.hpp"

namespace blocks::bench {
namespace {

using namespace geometry;

/// A corner near the top of a unit square, its neighbour corners, and two edges of the
/// square.
struct Case {
  Vec2 corner, before, after, p1, p2, q2;
};

constexpr int cases = 1024;

/// Makes cases with the corner between `low` and `high` above the top [L]. 0 is a tie,
/// which no filter decides.
std::vector<Case> near_an_edge(double low, double high) {
  const auto uniform = [](int number, std::uint32_t draw, double from, double to) {
    const auto bits =
        random_53_bits({7, 0}, static_cast<std::uint64_t>(number), draw, 0);
    return from + (to - from) * static_cast<double>(bits) * 0x1p-53;
  };
  std::vector<Case> made;
  for (int i = 0; i < cases; ++i) {
    const Vec2 corner(uniform(i, 0, 0.1, 0.9), 1.0 + uniform(i, 1, low, high));
    made.push_back({corner, corner + Vec2(1.0, uniform(i, 2, -0.1, 0.1)),
                    corner + Vec2(uniform(i, 3, -0.1, 0.1), 1.0), Vec2(0, 1),
                    Vec2(1, 1), Vec2(1, 0)});
  }
  return made;
}

/// Registers a benchmark that calls `ask` for one case after another.
template <class Ask>
void add(std::vector<std::string>& names, const std::string& name, std::vector<Case> of,
         Ask ask) {
  names.push_back(name);
  benchmark::RegisterBenchmark(
      name.c_str(), [of = std::move(of), ask](benchmark::State& state) {
        int i = 0;
        for (auto _ : state) {
          benchmark::DoNotOptimize(ask(of[static_cast<std::size_t>(i)]));
          i = (i + 1) % cases;
        }
      });
}

/// Registers all benchmarks and returns their names in order.
std::vector<std::string> register_all() {
  std::vector<std::string> names;
  const auto touching = near_an_edge(-1e-3, 1e-3);
  add(names, "overlap_sign", touching,
      [](const Case& k) { return overlap_sign(k.corner, k.p1, k.p2); });
  add(names, "near_or_inside", touching,
      [](const Case& k) { return near_or_inside(k.corner, k.p1, k.p2); });
  add(names, "between", touching,
      [](const Case& k) { return between(k.corner, k.p1, k.p2); });
  add(names, "faces_edge", touching,
      [](const Case& k) { return faces_edge(k.corner, k.after, k.p1, k.p2); });
  add(names, "compare_depths", touching, [](const Case& k) {
    return compare_depths(k.corner, k.p1, k.p2, k.corner, k.p2, k.q2);
  });
  add(names, "(19), between, (20) twice", near_an_edge(-1e-3, -1e-4),
      [](const Case& k) {
        return overlap_sign(k.corner, k.p1, k.p2) > 0 &&
               between(k.corner, k.p1, k.p2) &&
               faces_edge(k.corner, k.before, k.p1, k.p2) &&
               faces_edge(k.corner, k.after, k.p1, k.p2);
      });
  add(names, "overlap_sign of a tie, exact", near_an_edge(0, 0),
      [](const Case& k) { return overlap_sign(k.corner, k.p1, k.p2); });
  add(names, "contact law", touching, [](const Case& k) {
    const dynamics::ContactLaw law = {1e9, 1e9, 0.6, 5e-5};
    auto state = dynamics::usual_state(law, 1.0, k.before.y());
    dynamics::ContactForce<double> force;
    dynamics::apply_usual(law, {k.corner.y() - 1.0, k.after.x(), 1e-3, 1e4, 0.0}, state,
                          force);
    return force.normal + force.shear + state.normal + state.shear;
  });
  return names;
}

/// Keeps the times and prints nothing.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        times[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
  }
  std::map<std::string, std::vector<double>> times;
};

}  // namespace

std::vector<Row> time_kernels(int rounds, double seconds) {
  std::vector<std::string> words{"bench",
                                 fmt::format("--benchmark_min_time={}", seconds),
                                 fmt::format("--benchmark_repetitions={}", rounds),
                                 "--benchmark_enable_random_interleaving=true"};
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  const std::vector<std::string> names = register_all();
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<Row> rows;
  for (const std::string& name : names)
    rows.push_back(
        {"predicates", name, "blocks", 1, 0, "call", median(collector.times[name])});
  return rows;
}

}  // namespace blocks::bench
