#include "run/safety/safety_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/counted.hpp"

namespace blocks::run {
namespace {

/// The card and its line, which a card of the command line does not have.
std::string place_of(const SafetyFactor& card) {
  return card.line > 0 ? fmt::format("FOS in line {}: ", card.line) : "FOS: ";
}

const SafetyTrial* trial_at(std::span<const SafetyTrial> trials, double factor) {
  const auto found = std::find_if(trials.begin(), trials.end(), [&](const auto& trial) {
    return trial.factor == factor;
  });
  return found == trials.end() ? nullptr : &*found;
}

/// What to do about a bound at which the model is not what it should be.
std::string bound_text(const SafetyFactor& card, std::span<const SafetyTrial> trials,
                       double factor, const char* bound, const char* other) {
  const SafetyTrial* const trial = trial_at(trials, factor);
  const bool undecided = trial != nullptr && trial->outcome == TrialOutcome::undecided;
  return fmt::format("with strength / {:g}, the {} bound, the model is {}: ", factor,
                     bound, trial == nullptr ? "" : describe(trial->outcome)) +
         (undecided ? fmt::format("give more than {} with ncycle",
                                  counted(card.max_steps, "step"))
                    : fmt::format("give a {} {} bound, or none", other, bound));
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

std::vector<std::string> state_warnings(const SafetyFactor& card, std::size_t exits,
                                        bool moves) {
  std::vector<std::string> warnings;
  if (exits > 0)
    warnings.push_back(
        place_of(card) +
        fmt::format("{} left the domain before it, and only the rest is judged: if "
                    "rock has failed on its way to rest, bring it to rest with strong "
                    "joints first, and give their true strength before FOS",
                    exits == 1 ? "1 block has" : fmt::format("{} blocks have", exits)));
  if (moves)
    warnings.push_back(place_of(card) +
                       "blocks move, and trials should start from rest: put SOLVE "
                       "between the last card that moves them and FOS");
  return warnings;
}

std::string safety_warning(const SafetyFactor& card,
                           std::span<const SafetyTrial> trials) {
  const SafetyBracket bracket = bracket_of(trials);
  const std::string where = place_of(card);
  if (card.lower > 0.0 && !bracket.stable)
    return where + bound_text(card, trials, card.lower, "lower", "smaller");
  if (bracket.stable && card.upper > 0.0 && !bracket.failing)
    return where + bound_text(card, trials, card.upper, "upper", "larger");
  if (!(bracket.stable && bracket.failing) && count_undecided(trials) > 0)
    return where + fmt::format("trials are undecided after {}: give more with ncycle, "
                               "or look for blocks that neither come to rest nor fail, "
                               "maybe because the forces were not balanced before",
                               counted(card.max_steps, "step"));
  if (!bracket.stable)
    return where + "the model fails with all factors tried, even with 64 times the "
                   "strength: joints cannot hold it, or its forces were not balanced "
                   "before";
  if (!bracket.failing)
    return where +
           "the model is stable with all factors tried, even with a sixty-fourth "
           "of the strength: it stands without the strength of joints";
  if (*bracket.failing - *bracket.stable <= card.width)
    return "";
  return where + fmt::format("the bracket is wider than {:g}, because trials within it "
                             "are undecided after {}: give more with ncycle",
                             card.width, counted(card.max_steps, "step"));
}

}  // namespace blocks::run
