// One frame of the study of contact detection, as a run of a sweep. Independent of
// plans and folders.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "study/scene.hpp"
#include "sweep/axes.hpp"

namespace blocks::sweep {

/// The seed of the frames of a sweep, the default of `blocks study contacts`.
inline constexpr std::uint64_t study_seed = 1982;

/// Returns the scene of a run of a study, whose only set is "scene=NAME".
std::string scene_of(const Variation& run);

/// Runs the variants in one frame of a scene, as `blocks study contacts SCENE --first
/// FRAME --frames 1 --seed SEED` does, with one thread.
///
/// frame: its number, >= 0. seed: of the frames. variants: names, such as "default".
/// The result depends on the arguments only. It has the number of steps and, for each
/// variant, the quantities of docs/robustness.md#what-is-counted:
///
///     {"steps": 2000, "default": {"could_hang": 1, "hung": 0, "fell": 0,
///      "wrong_signs": 0.0, "wrong_tangents": 0.0, "phantom": 0.0, "missed": 0.0,
///      "speed_lost": 0.001, "energy_error": 2e-9, "diverged": 0,
///      "diverged_step": null}, ...}
///
/// Shares range from 0 to 1, and values that were not measured are null. A variant that
/// cannot make its blocks in this frame has {"refused": "why"} instead.
///
/// Throws study::UnfitBlock if the scene itself cannot be made in this frame, and
/// std::out_of_range for an unknown scene or variant.
nlohmann::ordered_json study_outcome(study::Scene scene, int frame, std::uint64_t seed,
                                     const std::vector<std::string>& variants);

/// Does the same for a scene of the program, such as "stake".
nlohmann::ordered_json study_outcome(const std::string& scene, int frame,
                                     std::uint64_t seed,
                                     const std::vector<std::string>& variants);

}  // namespace blocks::sweep
