// One variant of the rules in one scene and one frame: what went wrong.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/statistics.hpp"
#include "study/variants.hpp"

namespace blocks::study {

/// Definitions: docs/robustness.md.
struct Outcome {
  SignTally signs;
  long acting = 0;   ///< contacts that acted, summed over the steps
  long exact = 0;    ///< contacts that the default rules would have acting, likewise
  long phantom = 0;  ///< acted, though the default rules reject them where they stand
  long missed = 0;   ///< did not act, though the default rules accept them
  bool could_hang = false;  ///< a free block was expected to move
  bool hung = false, fell_through = false;
  /// How far at most a block fell behind its expected speed, as a share of the fastest
  /// one expected; NaN: not known, or nothing is to move.
  double speed_lost = not_asked;
  /// Largest wrong change of the total energy during the run, over the weight times the
  /// size plus the kinetic energy at the start; NaN where loads do work or blocks store
  /// energy.
  double energy_error = 0.0;
  long diverged = -1;  ///< first step whose acting contacts differ from default's, -1:
                       ///< none (not asked of variants that change the corners)
};

/// Hash of the acting contacts of each step.
using Trace = std::vector<std::uint64_t>;

/// Runs `steps` steps. With an empty trace fills it, else compares with it.
Outcome measure(const Scene& scene, const Frame& frame, const Variant& variant,
                long steps, Trace& trace);

/// A deck's scene expects what the variant does in the deck's own frame. Comes back
/// with what speaks against that run as a measure, "is unsound: ..."; empty: nothing. A
/// run in doubt ends there.
std::string set_expectation(Scene& scene, const Variant& variant, long steps);

}  // namespace blocks::study
