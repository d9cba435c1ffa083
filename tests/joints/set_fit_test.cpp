// Joint sets recovered from the networks that they made: a short form of
// `./go validate traces`.
#include <gtest/gtest.h>

#include "joints/set_fit.hpp"
#include "validation/traces/maps.hpp"
#include "validation/traces/recovery.hpp"

namespace blocks::joints {
namespace {

using geometry::JointLaw;
using testing::generated;
using testing::joint_set;
using testing::rectangle;
using testing::SetNumbers;

/// Fits 50 maps of a case. Every field of every set must be covered in at least 41 of
/// them: 47.5 are expected, and 41 are 4 deviations less.
void expect_recovery(const std::string& name) {
  constexpr int maps = 50, least = 41;
  for (const validation::RecoveryCase& one : validation::recovery_cases()) {
    if (one.name != name)
      continue;
    const validation::Recovery found = validation::recover(one, maps);
    EXPECT_EQ(found.right, maps);
    for (const validation::RecoveredField& field : found.fields)
      EXPECT_GE(field.covered, least) << field.name << " of set " << field.set;
    return;
  }
  FAIL() << "no case " << name;
}

TEST(SetFit, JointsThatRunThrough) { expect_recovery("run through, UNIFORM"); }

TEST(SetFit, ExponentialSpacing) { expect_recovery("run through, NEGEXP"); }

TEST(SetFit, JointsThatTurnAboutTheMiddle) { expect_recovery("run through, turned"); }

TEST(SetFit, TracesOnTracks) { expect_recovery("traces"); }

TEST(SetFit, DeviatingTracesOnTracks) { expect_recovery("traces, turned"); }

// Tracks at exponential distances are not told apart if traces deviate. Then the map
// tells the length of the traces and their number per area, and the set keeps both.
TEST(SetFit, WithoutTracksDensityAndLengthAreKept) {
  const SetNumbers given{30, 6, 1.2, 0, 5, 2, 4, 3, -25, 10, JointLaw::negexp};
  int without = 0;
  double p20 = 0.0;
  constexpr int maps = 30;
  for (unsigned seed = 1; seed <= maps; ++seed) {
    const NetworkFit fit = fit_sets(
        network_of(generated(rectangle(40.0, 30.0), {joint_set(given)}, seed)));
    ASSERT_EQ(fit.sets.size(), 1U);
    const SetFit& set = fit.sets[0];
    without += std::isnan(set.space.low) ? 1 : 0;
    p20 += 1.0 / (set.space.value * (set.trace.value + set.gap.value)) / maps;
    EXPECT_NEAR(set.trace.value, 5.0, 0.6);
  }
  EXPECT_GT(without, 25);
  EXPECT_NEAR(p20, 1.0 / (1.2 * 9.0), 0.06 / (1.2 * 9.0));
}

// The traces of a fitted set have the length per area of the map.
TEST(SetFit, AFitOfAFitHasTheSameDensity) {
  const SetNumbers given{30, 6, 1.2, 0, 5, 2, 4, 3, -25, 10, JointLaw::negexp};
  double map = 0.0, model = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const SetFit set =
        fit_sets(network_of(generated(rectangle(40.0, 30.0), {joint_set(given)}, seed)))
            .sets.at(0);
    SetNumbers made{set.dip.value,   set.ddev.value, set.space.value, set.sdev.value,
                    set.trace.value, set.tdev.value, set.gap.value,   set.gdev.value,
                    set.start.x(),   set.start.y(),  set.law};
    map += set.p21 / 20.0;
    const Network again =
        network_of(generated(rectangle(40.0, 30.0), {joint_set(made)}, seed + 1000));
    model += again.length() / again.area / 20.0;
  }
  EXPECT_NEAR(model / map, 1.0, 0.06);
}

TEST(SetFit, LinesInAllDirectionsArePoisson) {
  SetNumbers lines;
  lines.space = 1.0;
  lines.law = JointLaw::poisson;
  lines.x0 = 20.0, lines.y0 = 15.0;
  int poisson = 0, covered = 0;
  constexpr int maps = 40;
  for (unsigned seed = 1; seed <= maps; ++seed) {
    const NetworkFit fit = fit_sets(
        network_of(generated(rectangle(40.0, 30.0), {joint_set(lines)}, seed)));
    if (fit.sets.size() != 1 || fit.sets[0].law != JointLaw::poisson)
      continue;
    ++poisson;
    const Estimate& space = fit.sets[0].space;
    covered += space.low <= 1.0 && 1.0 <= space.high ? 1 : 0;
  }
  EXPECT_GE(poisson, 32);
  EXPECT_GE(covered, 0.8 * poisson);
}

}  // namespace
}  // namespace blocks::joints
