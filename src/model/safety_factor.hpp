// The factor of safety by reduction of strength (docs/stability.md): the trials of FOS
// cards, and which factor is tried next.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/settings.hpp"

namespace blocks {

/// How the run of a model with reduced strength ended.
enum class TrialOutcome : int { stable = 0, failing = 1, undecided = 2 };
inline constexpr int trial_outcomes = 3;
/// Returns the word: "stable", "failing" or "undecided".
const char* describe(TrialOutcome outcome);

/// One run with reduced strength.
struct SafetyTrial {
  int search = 0;       ///< index of its FOS card in Model::safety_factors
  double factor = 1.0;  ///< > 0; all strengths were divided by it
  TrialOutcome outcome = TrialOutcome::undecided;
  long steps = 0;
  double ratio = 0.0, local = 0.0;  ///< at the end (local_ratio.hpp)
  double speed = 0.0;               ///< [L/T] of the fastest block at the end
  int block = -1;                   ///< that block; -1: no block is free
  double moved = 0.0;               ///< [L] of the centroid that moved farthest
};

/// One FOS card.
struct SafetyFactor {
  int line = 0;        ///< line of the card in its deck, from 1
  double width = 0.0;  ///< > 0, wanted width of the bracket
  /// bounds given on the card; 0: none, so that they are looked for
  double lower = 0.0, upper = 0.0;
  /// steps in which the model forgets a disturbance (run::response_steps)
  long response = 0;
  long max_steps = 0;     ///< of a trial
  bool complete = false;  ///< all trials have been made
};

/// Returns the trials of one FOS card, `search`, in their order.
std::vector<SafetyTrial> trials_of(std::span<const SafetyTrial> trials, int search);

/// Returns the number of trials that did not decide.
long count_undecided(std::span<const SafetyTrial> trials);

/// The largest factor with which a model was stable, and the smallest one above it with
/// which it was failing. Empty: no trial was.
struct SafetyBracket {
  std::optional<double> stable, failing;
};
SafetyBracket bracket_of(std::span<const SafetyTrial> trials);

/// Returns the factor of the next trial; empty if the bracket is narrow enough, or
/// cannot become narrower. Bounds that the card gives are tried first. A bound that it
/// does not give is looked for from 1, or half of `upper` if that is less, by halves
/// and doubles, to 1/64 and 64, or until two trials were undecided. Then the bracket is
/// halved. If factors within it are undecided, the parts below and above all of them
/// are halved.
std::optional<double> next_factor(const SafetyFactor& card,
                                  std::span<const SafetyTrial> trials);

/// Returns up to `max` different factors that the next trials may need, the certain
/// one first. The result of a trial decides which of the others are needed.
std::vector<double> possible_factors(const SafetyFactor& card,
                                     std::span<const SafetyTrial> trials,
                                     std::size_t max);

/// Divides the strengths of all joints by `factor` > 0: friction coefficients, cohesion
/// and tensile strength, peak and residual, the whole shear strength of BARTON, and the
/// friction of FRICTN. Dilation is limited to the residual friction. Stiffness and the
/// strength of blocks (CRACK) stay.
void reduce_strength(Settings& settings, double factor);

}  // namespace blocks
