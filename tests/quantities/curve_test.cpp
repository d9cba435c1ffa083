// Curves are read as users write them, and are named in one form.
#include "quantities/curve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace blocks::quantities {
namespace {

using ::testing::HasSubstr;

TEST(Curve, HasOneName) {
  const std::pair<const char*, const char*> names[] = {
      {"ke", "kinetic_energy"},
      {"KINETIC_ENERGY", "kinetic_energy"},
      {"VELY:3", "vy:3"},
      {"y:9.2", "y:9.2"},
      {"y:6-9", "y:6-9"},
      {"y:6-9:mean", "y:6-9"},
      {"y:1-3/6/8-9:max", "y:1-3/6/8-9:max"},
      {"y:6/8:mean", "y:6/8"},
      {"y:6-9:p90", "y:6-9:p90"},
      {"y:material=2:max", "y:material=2:max"},
      {"y:material=old: red", "y:material=old: red"},
      {"speed:p99.5", "speed:p99.5"},
      {"overlap", "overlap"},
      {"energy:friction", "energy:friction"},
      {"ENERGY:at_play", "energy:at_play"},
      {"overlap:3-4:sum", "overlap:3-4:sum"},
      {"shear_force:3+2", "shear_force:2+3"},
      {"slip:joint=01", "slip:joint=1"},
      {"slip:2+3:mean", "slip:2+3:mean"},
      {"normal_stress:joint=7", "normal_stress:joint=7"}};
  for (const auto& [text, name] : names) {
    EXPECT_EQ(parse_curve(text).name(), name) << text;
    EXPECT_EQ(parse_curve(name).name(), name);
  }
}

TEST(Curve, SaysWhatCannotBeRead) {
  const std::pair<const char*, const char*> faults[] = {
      {"spede:3", "there is no quantity 'spede'"},
      {"speed", "speed needs a block or a statistic"},
      {"y:9-6", "'y:9-6' begins with the higher number"},
      {"y:3/2", "cannot read the place in 'y:3/2'"},
      {"y:1-3/3", "cannot read the place in 'y:1-3/3'"},
      {"y:1/", "cannot read the place in 'y:1/'"},
      {"y:0-6", "cannot read the place in 'y:0-6'"},
      {"y:", "cannot read the place in 'y:'"},
      {"y:material=", "cannot read the place in 'y:material='"},
      {"y:material=:max", "cannot read the place in 'y:material=:max'"},
      {"y:6-9:p101", "cannot read the place"},
      {"y:9:max", "'y:9:max': max is for several blocks"},
      {"y:9.2:p50", "p50 is for several blocks"},
      {"step:3", "step is a quantity of the whole model"},
      {"energy", "the energy account has no entry 'energy'"},
      {"energy:9", "the energy account has no entry 'energy:9'"},
      {"energy:friction:max", "the energy account has no entry 'energy:friction:max'"},
      {"mass:3.1", "a corner has no mass"},
      {"speed:2+3", "speed is a quantity of blocks, not of contacts"},
      {"slip:joint=", "cannot read the place in 'slip:joint='"},
      {"slip:joint=0", "cannot read the place"},
      {"slip:3+3", "'slip:3+3' has the same block twice"},
      {"shear_stress", "shear_stress needs a joint or two blocks"},
      {"shear_stress:3", "shear_stress is a quantity of joints"},
      {"shear_stress:sum", "shear_stress is a quantity of joints"},
      {"shear_stress:2+3:max", "without a statistic"}};
  for (const auto& [text, message] : faults) {
    try {
      parse_curve(text);
      ADD_FAILURE() << text;
    } catch (const CurveFault& fault) {
      EXPECT_THAT(fault.what(), HasSubstr(message));
      EXPECT_FALSE(fault.hint.empty()) << text;
    }
  }
}

}  // namespace
}  // namespace blocks::quantities
