#include "run/safety_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/counted.hpp"

namespace blocks::run {
namespace {

/// The card and its line, which a card of the command line does not have.
std::string place_of(const SafetyFactor& card) {
  return card.line > 0 ? fmt::format("FOS in line {}: ", card.line) : "FOS: ";
}

/// How the trial with this factor ended; empty if there was none.
std::string outcome_at(std::span<const SafetyTrial> trials, double factor) {
  for (const SafetyTrial& trial : trials)
    if (trial.factor == factor)
      return describe(trial.outcome);
  return "";
}

}  // namespace

std::string trial_line(const SafetyTrial& trial) {
  std::string text =
      fmt::format("FOS trial with strength / {:.6g}: {} after {}, ratio {:.2g}, local "
                  "ratio {:.2g}",
                  trial.factor, describe(trial.outcome), counted(trial.steps, "step"),
                  trial.ratio, trial.local);
  if (trial.block >= 0)
    text += fmt::format(", fastest block {} at {:.2g}, moved up to {:.2g}",
                        trial.block + 1, trial.speed, trial.moved);
  return text;
}

std::string safety_line(const SafetyFactor& card, std::span<const SafetyTrial> trials) {
  const SafetyBracket bracket = bracket_of(trials);
  long steps = 0;
  for (const SafetyTrial& trial : trials)
    steps += trial.steps;
  const std::string after =
      fmt::format(" ({}, {})", counted(static_cast<long>(trials.size()), "trial"),
                  counted(steps, "step"));
  const std::string where = place_of(card);
  if (bracket.stable && bracket.failing)
    return where +
           fmt::format("factor of safety between {:.6g} and {:.6g}", *bracket.stable,
                       *bracket.failing) +
           after;
  if (bracket.stable)
    return where + fmt::format("factor of safety above {:.6g}", *bracket.stable) +
           after;
  if (bracket.failing)
    return where + fmt::format("factor of safety below {:.6g}", *bracket.failing) +
           after;
  return where + "no factor of safety was found" + after;
}

std::string safety_warning(const SafetyFactor& card,
                           std::span<const SafetyTrial> trials) {
  const SafetyBracket bracket = bracket_of(trials);
  const std::string where = place_of(card);
  if (card.lower > 0.0 && !bracket.stable)
    return where +
           fmt::format("with strength / {:g}, the lower bound, the model is {}: "
                       "give a smaller lower bound, or none",
                       card.lower, outcome_at(trials, card.lower));
  if (!bracket.stable && !bracket.failing)
    return where + fmt::format("trials are undecided after {}: blocks neither come to "
                               "rest nor fail, maybe because the forces were not "
                               "balanced before",
                               counted(card.most_steps, "step"));
  if (!bracket.stable)
    return where + "the model is stable with none of the factors tried, and the "
                   "strength was raised 64 times: no strength of joints can hold it, "
                   "or its forces were not balanced before";
  if (card.upper > 0.0 && !bracket.failing)
    return where +
           fmt::format("with strength / {:g}, the upper bound, the model is {}: "
                       "give a larger upper bound, or none",
                       card.upper, outcome_at(trials, card.upper));
  if (!bracket.failing)
    return where + "the model fails with none of the factors tried, to 64: it stands "
                   "without the strength of joints";
  if (*bracket.failing - *bracket.stable <= card.width)
    return "";
  return where + fmt::format("the bracket is wider than {:g}, because trials within it "
                             "are undecided after {}: give more with ncycle",
                             card.width, counted(card.most_steps, "step"));
}

}  // namespace blocks::run
