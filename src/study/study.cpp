#include "study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include "study/beside_uncut.hpp"
#include "study/scene_deck.hpp"

namespace blocks::study {
namespace {

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

double share(long part, long whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : not_asked;
}

FrameValues values_of(const Outcome& outcome, int frame) {
  const SignTally& signs = outcome.signs;
  return {frame,
          outcome.could_hang,
          outcome.hung,
          outcome.fell_through,
          share(signs.wrong_areas, signs.areas),
          share(signs.wrong_tangents, signs.tangents),
          share(outcome.phantom, outcome.acting),
          share(outcome.missed, outcome.exact),
          outcome.speed_lost,
          outcome.energy_error,
          outcome.diverged >= 0 ? static_cast<double>(outcome.diverged) : not_asked,
          outcome.deep,
          {},
          outcome.why};
}

/// Runs a variant in one frame of a scene.
Outcome measure_scene(const Scene& scene, const Frame& frame, const Variant& variant,
                      long steps, Trace& trace) {
  return scene.uncut ? measure_beside_uncut(scene, frame, variant, steps, trace)
                     : measure(scene, frame, variant, steps, trace);
}

/// Counts the frames of each kind of the scene, in the order of their names.
std::vector<KindCount> count_kinds(const std::vector<FrameValues>& frames) {
  std::map<std::string, KindCount> by_name;
  for (const FrameValues& frame : frames) {
    if (frame.kind.empty())
      continue;
    KindCount& count = by_name[frame.kind];
    count.kind = frame.kind;
    ++count.frames;
    count.hung += frame.hung, count.fell += frame.fell, count.deep += frame.deep;
    count.failed += frame.hung || frame.fell || frame.deep;
  }
  std::vector<KindCount> kinds;
  for (const auto& [name, count] : by_name)
    kinds.push_back(count);
  return kinds;
}

/// The values of one quantity in the frames in which it was measured.
std::vector<double> measured(const std::vector<FrameValues>& frames,
                             double FrameValues::*value) {
  std::vector<double> all;
  for (const FrameValues& frame : frames)
    if (!std::isnan(frame.*value))
      all.push_back(frame.*value);
  return all;
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
  const double max = scene.farthest * scene.size * frame.scale;
  if (!choice.offset && frame.offset.norm() > 1.001 * max)
    frame.offset *= max / frame.offset.norm();
  return frame;
}

/// The reason why the blocks of a scene cannot be made in some frame; empty if they can
/// in every frame.
std::string refusal(const Scene& scene, const StudyChoice& choice, Corners corners) {
  for (int f = choice.first; f < choice.first + choice.count; ++f)
    try {
      Scene varied;
      const Scene& here = scene_in_frame(scene, choice.frames.seed, f, varied);
      const Frame frame = frame_of(here, choice.frames, f);
      place(here.model, frame, corners);
      if (here.uncut) {
        place(here.uncut->model, frame, corners);
        place(here.uncut->marked, frame, corners);
      }
    } catch (const UnfitBlock& unfit) {
      return fmt::format("{} (frame {})", unfit.what(), f);
    }
  return {};
}

}  // namespace

std::string first_deck(const Scene& scene, const StudyChoice& choice) {
  Scene varied;
  const Scene& here = scene_in_frame(scene, choice.frames.seed, choice.first, varied);
  return deck_of_frame(here, frame_of(here, choice.frames, choice.first),
                       choice.steps > 0 ? choice.steps : here.steps);
}

Row summarise(const Variant& variant, const std::vector<FrameValues>& frames,
              std::uint64_t seed) {
  Row row;
  row.variant = &variant;
  row.frames = static_cast<int>(frames.size());
  bool could_hang = false;
  for (const FrameValues& frame : frames) {
    could_hang |= frame.could_hang;
    if (frame.hung)
      row.hung_in.push_back(frame.frame);
    if (frame.fell)
      row.fell_in.push_back(frame.frame);
    if (frame.deep)
      row.deep_in.push_back(frame.frame);
    if (!frame.why.empty())
      row.reasons.push_back({frame.frame, frame.kind, frame.why});
  }
  const auto mean_of = [&](double FrameValues::*value) {
    return mean(measured(frames, value), seed);
  };
  row.hung = static_cast<long>(row.hung_in.size());
  row.fell = static_cast<long>(row.fell_in.size());
  row.wrong_signs = mean_of(&FrameValues::wrong_signs);
  row.wrong_tangents = mean_of(&FrameValues::wrong_tangents);
  row.phantom = mean_of(&FrameValues::phantom);
  row.missed = mean_of(&FrameValues::missed);
  if (could_hang)
    row.hang_ups = rate(row.hung, row.frames);
  row.speed_lost = mean_of(&FrameValues::speed_lost);
  row.fall_throughs = rate(row.fell, row.frames);
  row.kinds = count_kinds(frames);
  row.deep = static_cast<long>(row.deep_in.size());
  if (!row.kinds.empty())
    row.deep_frames = rate(row.deep, row.frames);
  row.energy = mean_of(&FrameValues::energy_error);
  const auto energy = measured(frames, &FrameValues::energy_error);
  if (!energy.empty())
    row.worst_energy = *std::max_element(energy.begin(), energy.end());
  const auto steps = measured(frames, &FrameValues::diverged);
  row.diverged = static_cast<long>(steps.size());
  row.divergences = rate(row.diverged, row.frames);
  row.divergence_step = median(steps);
  return row;
}

void drop_void_counts(Study& study) {
  if (study.expected.empty())
    return;
  const auto differs_always = [&](const Row& row) {
    return row.variant->name == study.expected && row.frames > 1 &&
           (row.hung == row.frames || row.fell == row.frames);
  };
  if (!study.doubt.empty())
    study.not_counted = fmt::format("the run of {} {}", study.expected, study.doubt);
  else if (std::any_of(study.rows.begin(), study.rows.end(), differs_always))
    study.not_counted = fmt::format("{} repeats its own motion in no other frame, as "
                                    "after a bounce",
                                    study.expected);
  else
    return;
  for (Row& row : study.rows) {
    row.hung = row.fell = 0;
    row.hang_ups = row.fall_throughs = Estimate();
    row.hung_in.clear();
    row.fell_in.clear();
  }
}

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
  // For each variant, the values of each frame.
  std::vector<std::vector<FrameValues>> all(
      choice.variants.size(),
      std::vector<FrameValues>(static_cast<std::size_t>(choice.count)));
  in_parallel(choice.count, choice.threads, [&](int f) {
    Scene varied;
    const int number = choice.first + f;
    const Scene& here = scene_in_frame(scene, choice.frames.seed, number, varied);
    const Frame frame = frame_of(here, choice.frames, number);
    Trace trace;
    const Outcome leading = measure_scene(here, frame, reference, study.steps, trace);
    for (std::size_t v = 0; v < choice.variants.size(); ++v) {
      const Variant& variant = *choice.variants[v];
      FrameValues& values = all[v][static_cast<std::size_t>(f)];
      values = values_of(&variant == &reference
                             ? leading
                             : measure_scene(here, frame, variant, study.steps, trace),
                         number);
      values.kind = here.kind;
    }
  });
  std::size_t ran = 0;
  for (std::size_t v = 0; v < all_chosen.variants.size(); ++v) {
    if (refusals[v].empty()) {
      study.rows.push_back(
          summarise(*choice.variants[ran], all[ran], choice.frames.seed));
      ++ran;
      continue;
    }
    Row& row = study.rows.emplace_back();
    row.variant = all_chosen.variants[v];
    row.refused = refusals[v];
  }
  drop_void_counts(study);
  return study;
}

}  // namespace blocks::study
