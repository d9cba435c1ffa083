// What can be asked of a run, and how its results answer.
#include "report/measure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "report/profile_band.hpp"
#include "report/statistics.hpp"

namespace blocks::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::set<std::string> outcome_names = {"aspect:max", "blocks", "p21"};

Measure parsed(const std::string& text, bool outcomes_first = false) {
  return parse_measure(text, outcome_names, outcomes_first);
}

std::string fault(const std::string& text) {
  try {
    parsed(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(Measure, ACurveHasAMoment) {
  EXPECT_EQ(parsed("y:9").when, Measure::When::end);
  EXPECT_EQ(parsed("y:9@end").name, "y:9");
  EXPECT_EQ(parsed("y:6-9@max").when, Measure::When::largest);
  EXPECT_EQ(parsed("KE@0.50").name, "kinetic_energy@0.5");
  EXPECT_EQ(parsed("dy:min@0.5").time, 0.5);
}

TEST(Measure, ALimitMakesAShare) {
  const Measure below = parsed("dy:min@max<-1.50");
  EXPECT_EQ(below.name, "dy:min@max<-1.5");
  EXPECT_EQ(below.with_limit(-2.0), 1.0);
  EXPECT_EQ(below.with_limit(-1.5), 0.0);
  EXPECT_TRUE(std::isnan(below.with_limit(no_number)));
  EXPECT_EQ(parsed("p21>3").with_limit(3.5), 1.0);
}

// The number of blocks is a curve, and a measure of the generated blocks.
TEST(Measure, TheKindOfTheSweepDecidesBetweenCurveAndOutcome) {
  EXPECT_EQ(parsed("blocks").from, Measure::From::curve);
  EXPECT_EQ(parsed("blocks", true).from, Measure::From::outcome);
  EXPECT_EQ(parsed("outcome.blocks").from, Measure::From::outcome);
  EXPECT_EQ(parsed("aspect:max").key, "aspect:max");
  EXPECT_EQ(parsed("profile:min").from, Measure::From::profile);
}

TEST(Measure, MayNameAMaterialWithASignOfLimits) {
  EXPECT_FALSE(parsed("y:material=phi<30:max").limit);
  EXPECT_EQ(parsed("y:material=phi<30:max>2").limit->value, 2.0);
}

TEST(Measure, FaultsNameWhatIsPossible) {
  EXPECT_THAT(fault("aspct"), HasSubstr("blocks, p21; with :max: aspect"));
  EXPECT_THAT(fault("y:9@late"), HasSubstr("y:9@0.5 is the value at that time"));
  EXPECT_THAT(fault("dy:min<low"), HasSubstr("needs a number after <"));
  EXPECT_THAT(fault("p21@1"), HasSubstr("there is no quantity 'p21'"));
}

TEST(Profile, IsLinearBetweenPlacesAndConstantBeyondThem) {
  const ProfileGrid grid(0.0, 20.0);
  const auto values = grid.resampled({{4.0, 6.0, 8.0}, {1.0, no_number, 5.0}});
  ASSERT_EQ(values.size(), profile_positions);
  EXPECT_EQ(grid.positions()[60], 6.0);
  EXPECT_EQ(values.front(), 1.0);
  EXPECT_EQ(values.back(), 5.0);
  EXPECT_NEAR(values[60], 3.0, 1e-12) << "a place without a value is left out";
  EXPECT_TRUE(std::isnan(grid.resampled({{4.0}, {no_number}}).front()));
}

TEST(Profile, TheBandIsMadeOfQuantilesAtEachPosition) {
  std::vector<std::vector<double>> runs;
  std::vector<const std::vector<double>*> profiles;
  for (int i = 0; i <= 100; ++i)
    runs.emplace_back(profile_positions, static_cast<double>(i));
  for (const auto& run : runs)
    profiles.push_back(&run);
  const ProfileBand band = band_of(profiles);
  EXPECT_EQ(band.runs, 101U);
  EXPECT_NEAR(band.low[7], 5.0, 1e-12);
  EXPECT_NEAR(band.median[7], 50.0, 1e-12);
  EXPECT_NEAR(band.high[7], 95.0, 1e-12);
}

}  // namespace
}  // namespace blocks::report
