// Joint sets recovered from the networks that they made: a short form of
// `./go validate traces`.
#include <gtest/gtest.h>

#include "joints/set_fit.hpp"
#include "validation/traces/maps.hpp"
#include "validation/traces/recovery.hpp"

namespace blocks::joints {
namespace {

using geometry::SpacingLaw;
using testing::generated;
using testing::joint_set;
using testing::rectangle;
using testing::SetNumbers;

SetNumbers numbers_of(const SetFit& set) {
  return {set.dip.value,   set.ddev.value, set.space.value, set.sdev.value,
          set.trace.value, set.tdev.value, set.gap.value,   set.gdev.value,
          set.start.x(),   set.start.y(),  set.law};
}

/// Fits 50 maps of a case. Every field of every set must be covered in at least 41 of
/// them: 47.5 are expected, and 41 are 4 deviations less.
void expect_recovery(const std::string& name) {
  constexpr int maps = 50, min = 41;
  for (const validation::RecoveryCase& one : validation::recovery_cases()) {
    if (one.name != name)
      continue;
    const validation::Recovery found = validation::recover(one, maps);
    EXPECT_EQ(found.right, maps);
    for (const validation::RecoveredField& field : found.fields)
      EXPECT_GE(field.covered, min) << field.name << " of set " << field.set;
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
  const SetNumbers given{30, 6, 1.2, 0, 5, 2, 4, 3, -25, 10, SpacingLaw::negexp};
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
  const SetNumbers given{30, 6, 1.2, 0, 5, 2, 4, 3, -25, 10, SpacingLaw::negexp};
  double map = 0.0, model = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const SetFit set =
        fit_sets(network_of(generated(rectangle(40.0, 30.0), {joint_set(given)}, seed)))
            .sets.at(0);
    const SetNumbers made = numbers_of(set);
    map += set.p21 / 20.0;
    const Network again =
        network_of(generated(rectangle(40.0, 30.0), {joint_set(made)}, seed + 1000));
    model += again.length() / again.area / 20.0;
  }
  EXPECT_NEAR(model / map, 1.0, 0.06);
}

/// Beds, and cross joints that end at them.
TraceMap beds_and_cross_joints(const SetNumbers& beds, const SetNumbers& cross,
                               std::uint64_t seed) {
  const auto window = rectangle(40.0, 30.0);
  TraceMap map = generated(window, {joint_set(beds)}, seed);
  const TraceMap whole = generated(window, {joint_set(cross)}, seed + 500);
  for (const auto& one : geometry::ended_at(whole.segments, map.segments, {}))
    map.segments.push_back({one.from, one.to, ++map.traces});
  return map;
}

// The beds are apart by different distances, so the middle of a trace is in a wide
// interval more often. The model has the length per area of the map all the same.
TEST(SetFit, TracesThatEndAtBedsGetUntil) {
  const SetNumbers beds{10, .5, 2, 1.2, 0, 0, 0, 0, -3, -7};
  const SetNumbers cross{100, 8, 1.5, 0, 9, 0, 0, 0, -3, -7, SpacingLaw::negexp};
  double map = 0.0, model = 0.0;
  for (unsigned seed = 1; seed <= 15; ++seed) {
    const Network network = network_of(beds_and_cross_joints(beds, cross, seed));
    const NetworkFit fit = fit_sets(network);
    ASSERT_EQ(fit.sets.size(), 2U);
    EXPECT_EQ(fit.sets[0].until, 0);
    ASSERT_EQ(fit.sets[1].until, 1);
    map += network.length() / network.area / 15.0;
    const Network again = network_of(beds_and_cross_joints(
        numbers_of(fit.sets[0]), numbers_of(fit.sets[1]), seed + 1000));
    model += again.length() / again.area / 15.0;
    EXPECT_GT(again.nodes.y, 10 * again.nodes.i);
  }
  EXPECT_NEAR(model / map, 1.0, 0.06);
}

TEST(SetFit, LinesInAllDirectionsArePoisson) {
  SetNumbers lines;
  lines.space = 1.0;
  lines.law = SpacingLaw::poisson;
  lines.x0 = 20.0, lines.y0 = 15.0;
  int poisson = 0, covered = 0;
  constexpr int maps = 40;
  for (unsigned seed = 1; seed <= maps; ++seed) {
    const NetworkFit fit = fit_sets(
        network_of(generated(rectangle(40.0, 30.0), {joint_set(lines)}, seed)));
    if (fit.sets.size() != 1 || fit.sets[0].law != SpacingLaw::poisson)
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
