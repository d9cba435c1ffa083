#include "model/safety_factor.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <limits>

namespace blocks {
namespace {

constexpr double min_factor = 1.0 / 64.0, largest_factor = 64.0;

bool was_tried(std::span<const SafetyTrial> trials, double factor) {
  return std::any_of(trials.begin(), trials.end(),
                     [&](const SafetyTrial& trial) { return trial.factor == factor; });
}

bool is_undecided(const SafetyTrial& trial) {
  return trial.outcome == TrialOutcome::undecided;
}

/// Returns the factor to try while no trial was stable. Two undecided ones are enough:
/// more strength does not let such a model come to rest.
std::optional<double> below_all(const SafetyFactor& card,
                                std::span<const SafetyTrial> trials) {
  if (card.lower > 0.0)
    return was_tried(trials, card.lower) ? std::nullopt : std::optional(card.lower);
  if (trials.empty())
    return card.upper > 0.0 ? std::min(1.0, 0.5 * card.upper) : 1.0;
  double min = std::numeric_limits<double>::infinity();
  for (const SafetyTrial& trial : trials)
    min = std::min(min, trial.factor);
  return min > min_factor && count_undecided(trials) < 2 ? std::optional(0.5 * min)
                                                         : std::nullopt;
}

/// Returns the factor to try while no trial was failing; likewise.
std::optional<double> above_all(const SafetyFactor& card,
                                std::span<const SafetyTrial> trials) {
  if (card.upper > 0.0)
    return was_tried(trials, card.upper) ? std::nullopt : std::optional(card.upper);
  double largest = 0.0;
  for (const SafetyTrial& trial : trials)
    largest = std::max(largest, trial.factor);
  return largest < largest_factor && count_undecided(trials) < 2
             ? std::optional(2.0 * largest)
             : std::nullopt;
}

}  // namespace

const char* describe(TrialOutcome outcome) {
  constexpr const char* words[trial_outcomes] = {"stable", "failing", "undecided"};
  return words[static_cast<int>(outcome)];
}

std::vector<SafetyTrial> trials_of(std::span<const SafetyTrial> trials, int search) {
  std::vector<SafetyTrial> own;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(own),
               [&](const SafetyTrial& trial) { return trial.search == search; });
  return own;
}

long count_undecided(std::span<const SafetyTrial> trials) {
  return std::count_if(trials.begin(), trials.end(), is_undecided);
}

SafetyBracket bracket_of(std::span<const SafetyTrial> trials) {
  SafetyBracket bracket;
  for (const SafetyTrial& trial : trials)
    if (trial.outcome == TrialOutcome::failing &&
        (!bracket.failing || trial.factor < *bracket.failing))
      bracket.failing = trial.factor;
  for (const SafetyTrial& trial : trials)
    if (trial.outcome == TrialOutcome::stable &&
        (!bracket.failing || trial.factor < *bracket.failing) &&
        (!bracket.stable || trial.factor > *bracket.stable))
      bracket.stable = trial.factor;
  return bracket;
}

std::optional<double> next_factor(const SafetyFactor& card,
                                  std::span<const SafetyTrial> trials) {
  const SafetyBracket bracket = bracket_of(trials);
  if (!bracket.stable) {
    const auto below = below_all(card, trials);
    if (below || card.lower > 0.0)
      return below;
  }
  if (!bracket.failing)
    return above_all(card, trials);
  if (!bracket.stable)
    return std::nullopt;
  const double low = *bracket.stable, high = *bracket.failing;
  double first = high, last = low;  // of the undecided ones
  for (const SafetyTrial& trial : trials)
    if (trial.factor > low && trial.factor < high)
      first = std::min(first, trial.factor), last = std::max(last, trial.factor);
  if (first - low > card.width)
    return 0.5 * (low + first);
  if (first < high && high - last > card.width)
    return 0.5 * (last + high);
  return std::nullopt;
}

std::vector<double> possible_factors(const SafetyFactor& card,
                                     std::span<const SafetyTrial> trials,
                                     std::size_t max) {
  std::vector<double> factors;
  // Each entry is what may be known some trials later. Those with fewer trials are
  // first.
  std::deque<std::vector<SafetyTrial>> later = {{trials.begin(), trials.end()}};
  while (!later.empty() && factors.size() < max) {
    std::vector<SafetyTrial> known = std::move(later.front());
    later.pop_front();
    const std::optional<double> next = next_factor(card, known);
    if (!next)
      continue;
    if (std::find(factors.begin(), factors.end(), *next) == factors.end())
      factors.push_back(*next);
    for (const TrialOutcome outcome : {TrialOutcome::stable, TrialOutcome::failing}) {
      later.push_back(known);
      later.back().push_back({.factor = *next, .outcome = outcome});
    }
  }
  return factors;
}

void reduce_strength(Settings& settings, double factor) {
  settings.friction /= factor;
  for (auto& [id, law] : settings.joint_laws) {
    for (double* const strength :
         {&law.friction, &law.cohesion, &law.tension, &law.residual_friction,
          &law.residual_cohesion, &law.residual_tension, &law.strength_share})
      *strength /= factor;
    law.dilation = std::min(law.dilation, law.residual_friction);
  }
}

}  // namespace blocks
