// Measures what goes wrong with one variant of the rules in one scene and one frame.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/statistics.hpp"
#include "study/variants.hpp"

namespace blocks::study {

/// The quantities are defined in docs/robustness.md.
struct Outcome {
  SignTally signs;
  long acting = 0;          ///< contacts that acted, summed over the steps
  long exact = 0;           ///< contacts that act by the default rules, likewise
  long phantom = 0;         ///< acted, although the default rules reject them
  long missed = 0;          ///< did not act, although the default rules accept them
  bool could_hang = false;  ///< a free block was expected to move
  bool hung = false, fell_through = false;
  /// A contact acted that is far deeper than the shift that frees its block. Measured
  /// only beside an uncut domain.
  bool deep = false;
  std::string why;  ///< what failed first and when; only beside an uncut domain
  /// The largest loss of a block against its expected speed, as a share of the fastest
  /// expected speed. It is NaN if the motion is unknown or nothing should move.
  double speed_lost = not_asked;
  /// The largest wrong change of the total energy during the run, over the weight times
  /// the size plus the kinetic energy at the start. It is NaN if loads do work or
  /// blocks store energy.
  double energy_error = 0.0;
  long diverged = -1;  ///< first step whose acting contacts differ from default's; -1:
                       ///< none. Not measured for variants that change the corners
};

/// A hash of the acting contacts of each step.
using Trace = std::vector<std::uint64_t>;

/// Returns a hash of the contacts that act, in their order.
std::uint64_t hash_acting(const std::vector<Contact>& contacts);

/// Makes `steps` steps. Fills the trace if it is empty; otherwise compares with it.
Outcome measure(const Scene& scene, const Frame& frame, const Variant& variant,
                long steps, Trace& trace);

/// Sets the expected motion of a deck's scene to that of the variant in the deck's own
/// frame. Returns why that run is not a valid reference, "is unsound: ..."; empty if it
/// is. The run ends early if it is not valid.
std::string set_expectation(Scene& scene, const Variant& variant, long steps);

}  // namespace blocks::study
