#include "study/study.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

namespace blocks::study {
namespace {

using Outcomes = std::vector<Outcome>;  ///< of the variants, in one frame

/// Calls work(0) .. work(count - 1) from several threads; passes on what is thrown.
template <class Work> void in_parallel(int count, int threads, Work work) {
  std::atomic<int> next = 0;
  std::exception_ptr fault;
  std::mutex guard;
  const auto worker = [&] {
    for (int i = next++; i < count; i = next++)
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        fault = std::current_exception();
        next = count;
      }
  };
  std::vector<std::thread> others;
  for (int t = 1; t < std::min(threads, count); ++t)
    others.emplace_back(worker);
  worker();
  for (std::thread& other : others)
    other.join();
  if (fault)
    std::rethrow_exception(fault);
}

void add_share(std::vector<double>& shares, long part, long whole) {
  if (whole > 0)
    shares.push_back(static_cast<double>(part) / static_cast<double>(whole));
}

Row summarise(const StudyChoice& choice, const std::vector<Outcomes>& all,
              std::size_t v) {
  Row row;
  const std::uint64_t seed = choice.frames.seed;
  row.variant = choice.variants[v];
  row.frames = static_cast<int>(all.size());
  std::vector<double> signs, tangents, phantom, missed, energy, steps;
  for (int f = 0; f < row.frames; ++f) {
    const Outcome& o = all[static_cast<std::size_t>(f)][v];
    add_share(signs, o.signs.wrong_areas, o.signs.areas);
    add_share(tangents, o.signs.wrong_tangents, o.signs.tangents);
    add_share(phantom, o.phantom, o.acting);
    add_share(missed, o.missed, o.exact);
    if (!std::isnan(o.energy_error))
      energy.push_back(o.energy_error);
    if (o.hung)
      row.hung_in.push_back(choice.first + f);
    if (o.fell_through)
      row.fell_in.push_back(choice.first + f);
    if (o.diverged >= 0)
      steps.push_back(static_cast<double>(o.diverged));
  }
  row.hung = static_cast<long>(row.hung_in.size());
  row.fell = static_cast<long>(row.fell_in.size());
  row.diverged = static_cast<long>(steps.size());
  row.wrong_signs = mean(signs, seed);
  row.wrong_tangents = mean(tangents, seed);
  row.phantom = mean(phantom, seed);
  row.missed = mean(missed, seed);
  row.hang_ups = rate(row.hung, row.frames);
  row.fall_throughs = rate(row.fell, row.frames);
  row.energy = mean(energy, seed);
  row.worst_energy = energy.empty() ? std::numeric_limits<double>::quiet_NaN()
                                    : *std::max_element(energy.begin(), energy.end());
  row.median_step = median(steps);
  return row;
}

}  // namespace

Study run_study(Scene scene, const StudyChoice& choice) {
  Study study{
      scene.name, scene.what, choice.steps > 0 ? choice.steps : scene.steps, {}};
  if (!scene.expected)
    set_expectation(scene, study.steps);
  const Variant& reference = all_variants().front();
  std::vector<Outcomes> all(static_cast<std::size_t>(choice.count));
  in_parallel(choice.count, choice.threads, [&](int f) {
    const Frame frame = random_frame(choice.frames, choice.first + f, scene.size);
    Trace trace;
    const Outcome leading = measure(scene, frame, reference, study.steps, trace);
    for (const Variant* variant : choice.variants)
      all[static_cast<std::size_t>(f)].push_back(
          variant == &reference ? leading
                                : measure(scene, frame, *variant, study.steps, trace));
  });
  for (std::size_t v = 0; v < choice.variants.size(); ++v)
    study.rows.push_back(summarise(choice, all, v));
  return study;
}

}  // namespace blocks::study
