// Which factor is tried next, and what its bracket proves.
#include "model/safety_factor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace blocks {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::SizeIs;
using Judge = std::function<TrialOutcome(double factor)>;

Judge failing_above(double truth) {
  return [truth](double factor) {
    return factor < truth ? TrialOutcome::stable : TrialOutcome::failing;
  };
}

/// Makes all trials, and checks that none is made twice.
std::vector<SafetyTrial> search(const SafetyFactor& card, const Judge& judge) {
  std::vector<SafetyTrial> trials;
  while (const auto next = next_factor(card, trials)) {
    for (const SafetyTrial& trial : trials)
      EXPECT_NE(trial.factor, *next);
    trials.push_back({.factor = *next, .outcome = judge(*next)});
    if (trials.size() > 100)
      throw std::runtime_error("the search does not end");
  }
  return trials;
}

TEST(SafetyFactor, IsWithinItsBracketWhateverItIs) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-5.9, 5.9), part(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double truth = std::exp2(exponent(random));
    SafetyFactor card{.width = std::exp2(-10.0 * part(random))};
    if (i % 3 == 1)
      card.lower = truth * part(random);
    if (i % 5 == 1)
      card.upper = truth * (1.0 + part(random));
    const auto trials = search(card, failing_above(truth));
    const SafetyBracket bracket = bracket_of(trials);
    ASSERT_TRUE(bracket.stable && bracket.failing) << truth;
    EXPECT_LT(*bracket.stable, truth);
    EXPECT_GE(*bracket.failing, truth);
    EXPECT_LE(*bracket.failing - *bracket.stable, card.width);
  }
}

TEST(SafetyFactor, NeedsFewTrials) {
  const auto trials = search({.width = 0.01}, failing_above(1.3913));
  std::vector<double> factors;
  for (const SafetyTrial& trial : trials)
    factors.push_back(trial.factor);
  EXPECT_THAT(factors, ElementsAre(1, 2, 1.5, 1.25, 1.375, 1.4375, 1.40625, 1.390625,
                                   1.3984375));
}

// Where trials stay undecided, the bracket closes in on them from both sides.
TEST(SafetyFactor, IsNeverTakenFromUndecidedTrials) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> first(0.3, 3.0), width(0.0, 0.3);
  for (int i = 0; i < 1000; ++i) {
    const double low = first(random), high = low + width(random);
    const SafetyFactor card{.width = 0.01};
    const auto trials = search(card, [&](double factor) {
      return factor < low    ? TrialOutcome::stable
             : factor > high ? TrialOutcome::failing
                             : TrialOutcome::undecided;
    });
    const SafetyBracket bracket = bracket_of(trials);
    ASSERT_TRUE(bracket.stable && bracket.failing);
    EXPECT_LT(*bracket.stable, low);
    EXPECT_GT(*bracket.failing, high);
    EXPECT_LE(*bracket.failing - *bracket.stable, high - low + 2.0 * card.width);
  }
}

TEST(SafetyFactor, HasNoEndThatNoTrialProves) {
  const auto always = [](TrialOutcome outcome) {
    return [=](double) { return outcome; };
  };
  const auto stable = search({.width = 0.01}, always(TrialOutcome::stable));
  EXPECT_EQ(bracket_of(stable).stable, 64.0);
  EXPECT_FALSE(bracket_of(stable).failing);
  const auto failing = search({.width = 0.01}, always(TrialOutcome::failing));
  EXPECT_FALSE(bracket_of(failing).stable);
  EXPECT_EQ(bracket_of(failing).failing, 1.0 / 64.0);
  const auto undecided = search({.width = 0.01}, always(TrialOutcome::undecided));
  EXPECT_FALSE(bracket_of(undecided).stable || bracket_of(undecided).failing);
}

// A bound on the card that is wrong ends the search at once.
TEST(SafetyFactor, EndsAtABoundThatDoesNotHold) {
  EXPECT_THAT(search({.width = 0.01, .lower = 2.0, .upper = 3.0}, failing_above(1.5)),
              SizeIs(1));
  EXPECT_THAT(search({.width = 0.01, .lower = 1.0, .upper = 1.2}, failing_above(1.5)),
              SizeIs(2));
}

// Several trials at once never leave the way of one at a time.
TEST(SafetyFactor, KnowsTheFactorsThatMayBeNext) {
  const SafetyFactor card{.width = 0.01};
  const auto trials = search(card, failing_above(1.3913));
  for (std::size_t made = 0; made < trials.size(); ++made) {
    const std::span<const SafetyTrial> known(trials.data(), made);
    const auto possible = possible_factors(card, known, 4);
    ASSERT_FALSE(possible.empty());
    EXPECT_EQ(possible.front(), trials[made].factor);
    EXPECT_THAT(possible, SizeIs(::testing::Le(4u)));
    if (made + 1 < trials.size()) {
      EXPECT_THAT(possible, ::testing::Contains(trials[made + 1].factor));
    }
  }
  EXPECT_THAT(possible_factors(card, trials, 4), SizeIs(0));
}

TEST(SafetyFactor, DividesAllStrengthsOfJointsAndNothingElse) {
  Settings settings;
  settings.friction = 0.6;
  settings.crack_rules[1] = {.strength = 5.0, .min_area = 1.0};
  JointLaw law{.friction = 0.8, .cohesion = 10.0, .tension = 4.0};
  law.residual_friction = 0.4, law.residual_cohesion = 2.0, law.residual_tension = 1.0;
  law.dilation = 0.3, law.normal_stiffness = 7.0;
  settings.joint_laws[3] = law;
  reduce_strength(settings, 2.0);
  EXPECT_EQ(settings.friction, 0.3);
  EXPECT_EQ(settings.crack_rules[1].strength, 5.0);
  const JointLaw& now = settings.joint_laws[3];
  EXPECT_EQ(now.friction, 0.4);
  EXPECT_EQ(now.cohesion, 5.0);
  EXPECT_EQ(now.tension, 2.0);
  EXPECT_EQ(now.residual_friction, 0.2);
  EXPECT_EQ(now.residual_cohesion, 1.0);
  EXPECT_EQ(now.residual_tension, 0.5);
  EXPECT_EQ(now.strength_share, 0.5);
  EXPECT_EQ(now.dilation, 0.2);  // never above the residual friction
  EXPECT_EQ(now.normal_stiffness, 7.0);
}

}  // namespace
}  // namespace blocks
