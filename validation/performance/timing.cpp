#include "timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace blocks::bench {
namespace {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Returns the number of steps for which a turn takes `seconds` with warm caches.
long steps_for(Contestant& code, double seconds) {
  code.run(1);  // The first step builds the lists.
  for (long steps = 1;; steps *= 2) {
    const double taken = seconds_of_run(code, steps);
    if (taken >= 0.25 * seconds)
      return std::max(1L, std::lround(seconds / taken * static_cast<double>(steps)));
  }
}

std::vector<Times> take_turns(const std::vector<Contestant*>& codes, int rounds,
                              const std::vector<long>& steps) {
  std::vector<Times> times(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i)
    times[i].steps = steps[i];
  for (int round = 0; round < rounds; ++round)
    for (std::size_t turn = 0; turn < codes.size(); ++turn) {
      const std::size_t i = round % 2 == 0 ? turn : codes.size() - 1 - turn;
      const double taken = seconds_of_run(*codes[i], times[i].steps);
      times[i].nanoseconds.push_back(
          1e9 * taken /
          (codes[i]->work_per_step() * static_cast<double>(times[i].steps)));
    }
  return times;
}

}  // namespace

double seconds_of_run(Contestant& code, long steps) {
  const auto now = code.by_clock() ? wall_seconds : processor_seconds;
  const double start = now();
  code.run(steps);
  return now() - start;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 != 0 ? values[half]
                                : 0.5 * (values[half - 1] + values[half]);
}

Ratio ratio(const Times& first, const Times& second) {
  std::vector<double> of_pairs;
  for (std::size_t i = 0; i < first.nanoseconds.size(); ++i)
    of_pairs.push_back(second.nanoseconds[i] / first.nanoseconds[i]);
  const auto [min, max] = std::minmax_element(of_pairs.begin(), of_pairs.end());
  return {median(of_pairs), *min, *max};
}

std::vector<Times> take_turns(const std::vector<Contestant*>& codes, int rounds,
                              double seconds) {
  std::vector<long> steps;
  for (Contestant* code : codes)
    steps.push_back(steps_for(*code, seconds));
  return take_turns(codes, rounds, steps);
}

std::vector<Times> take_equal_turns(const std::vector<Contestant*>& codes, int rounds,
                                    long steps) {
  return take_turns(codes, rounds, std::vector<long>(codes.size(), steps));
}

}  // namespace blocks::bench
