#include "study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

namespace blocks::study {
namespace {

using Outcomes = std::vector<Outcome>;  ///< one for each variant, in one frame

/// Calls work(i) for i in [0, count) from several threads. Rethrows an exception of one
/// of them.
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
  std::vector<double> signs, tangents, phantom, missed, energy, steps, speeds;
  bool could_hang = false;
  for (int f = 0; f < row.frames; ++f) {
    const Outcome& o = all[static_cast<std::size_t>(f)][v];
    add_share(signs, o.signs.wrong_areas, o.signs.areas);
    add_share(tangents, o.signs.wrong_tangents, o.signs.tangents);
    add_share(phantom, o.phantom, o.acting);
    add_share(missed, o.missed, o.exact);
    if (!std::isnan(o.energy_error))
      energy.push_back(o.energy_error);
    if (!std::isnan(o.speed_lost))
      speeds.push_back(o.speed_lost);
    could_hang |= o.could_hang;
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
  if (could_hang)
    row.hang_ups = rate(row.hung, row.frames);
  row.speed_lost = mean(speeds, seed);
  row.fall_throughs = rate(row.fell, row.frames);
  row.energy = mean(energy, seed);
  if (!energy.empty())
    row.worst_energy = *std::max_element(energy.begin(), energy.end());
  row.divergences = rate(row.diverged, row.frames);
  row.divergence_step = median(steps);
  return row;
}

/// The options that reproduce the frames, as on the command line.
std::string options_again(const StudyChoice& choice) {
  std::string options;
  if (choice.frames.offset)
    options += fmt::format(" --offset {}", *choice.frames.offset);
  if (choice.frames.scale)
    options += fmt::format(" --scale {}", *choice.frames.scale);
  if (choice.frames.seed != FrameChoice().seed)
    options += fmt::format(" --seed {}", choice.frames.seed);
  if (choice.steps > 0)
    options += fmt::format(" --steps {}", choice.steps);
  if (choice.expected)
    options += fmt::format(" --expect {}", choice.expected->name);
  return options;
}

/// The frame with this number. Its random offset is limited to what the scene allows; a
/// chosen offset is kept.
Frame frame_of(const Scene& scene, const FrameChoice& choice, int number) {
  Frame frame = random_frame(choice, number, scene.size);
  const double most = scene.farthest * scene.size * frame.scale;
  if (!choice.offset && frame.offset.norm() > 1.001 * most)
    frame.offset *= most / frame.offset.norm();
  return frame;
}

/// The reason why the blocks of a scene cannot be made in some frame; empty if they can
/// in every frame.
std::string refusal(const Scene& scene, const StudyChoice& choice, Corners corners) {
  for (int f = choice.first; f < choice.first + choice.count; ++f)
    try {
      Scene varied;
      const Scene& here = scene_in_frame(scene, choice.frames.seed, f, varied);
      place(here.model, frame_of(here, choice.frames, f), corners);
    } catch (const UnfitBlock& unfit) {
      return fmt::format("{} (frame {})", unfit.what(), f);
    }
  return {};
}

}  // namespace

Study run_study(Scene scene, const StudyChoice& all_chosen) {
  StudyChoice choice = all_chosen;
  Study study{scene.name,
              scene.what,
              choice.steps > 0 ? choice.steps : scene.steps,
              {},
              {},
              {},
              options_again(choice),
              {},
              scene.must_pass};
  study.refused = refusal(scene, choice, Corners::sharp);
  if (!study.refused.empty())
    return study;
  std::vector<std::string> refusals;
  for (const Variant* variant : all_chosen.variants) {
    refusals.push_back(variant->corners == Corners::sharp
                           ? std::string()
                           : refusal(scene, choice, variant->corners));
    if (!refusals.back().empty())
      std::erase(choice.variants, variant);
  }
  const Variant& reference = all_variants().front();
  if (!scene.expected) {
    const Variant& measure_of = choice.expected ? *choice.expected : reference;
    study.expected = measure_of.name;
    study.doubt = set_expectation(scene, measure_of, study.steps);
  }
  std::vector<Outcomes> all(static_cast<std::size_t>(choice.count));
  in_parallel(choice.count, choice.threads, [&](int f) {
    Scene varied;
    const int number = choice.first + f;
    const Scene& here = scene_in_frame(scene, choice.frames.seed, number, varied);
    const Frame frame = frame_of(here, choice.frames, number);
    Trace trace;
    const Outcome leading = measure(here, frame, reference, study.steps, trace);
    for (const Variant* variant : choice.variants)
      all[static_cast<std::size_t>(f)].push_back(
          variant == &reference ? leading
                                : measure(here, frame, *variant, study.steps, trace));
  });
  std::size_t ran = 0;
  for (std::size_t v = 0; v < all_chosen.variants.size(); ++v) {
    if (refusals[v].empty()) {
      study.rows.push_back(summarise(choice, all, ran++));
      continue;
    }
    Row& row = study.rows.emplace_back();
    row.variant = all_chosen.variants[v];
    row.refused = refusals[v];
  }
  return study;
}

}  // namespace blocks::study
