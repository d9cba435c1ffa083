// Numbers along axes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "draw/axes.hpp"
#include "draw/value_range.hpp"

namespace blocks::draw {
namespace {

using ::testing::ElementsAre;

// Far from the origin all labels would have the same six digits.
TEST(Ticks, HaveAnOffsetFarFromTheOrigin) {
  const TickLabels far = label_ticks(1e9 - 1.1, 1e9 + 1.1, 5);
  EXPECT_THAT(far.labels, ElementsAre("-1", "-0.5", "0", "0.5", "1"));
  EXPECT_EQ(far.offset, "+1000000000");
  const TickLabels below = label_ticks(-500003.05, -500002.35, 4);
  EXPECT_THAT(below.labels, ElementsAre("0", "0.2", "0.4", "0.6"));
  EXPECT_EQ(below.offset, "-500003");
  EXPECT_EQ(below.axis_title("y [m]"), "y + 500003 [m]");
  const TickLabels national =
      label_ticks(500000, 500010, 5);  // The labels do not run from -10 to 0.
  EXPECT_THAT(national.labels, ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_EQ(national.offset, "+500000");
  EXPECT_EQ(national.axis_title("x [m]"), "x − 500000 [m]");
  EXPECT_EQ(national.axis_title("x"), "x − 500000");
  const TickLabels late = label_ticks(4e6 - 1.6e-4, 4e6, 4);  // No label is -5e-05.
  EXPECT_THAT(late.labels, ElementsAre("-0.00015", "-0.00010", "-0.00005", "0"));
  EXPECT_EQ(label_ticks(1000, 1100, 5).offset, "");
  EXPECT_TRUE(label_ticks(1e17, 1e17 + 64, 10).ticks.empty());  // Doubles are 16 apart.
}

TEST(Ticks, OfLargeAndSmallNumbersHaveAPowerOfTenInTheTitle) {
  const TickLabels energy = label_ticks(0.0, 1.8e6, 6);
  EXPECT_EQ(energy.titled("energy [J/m]"), "energy [10⁶ J/m]");
  EXPECT_THAT(energy.labels, ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1", "1.2",
                                         "1.4", "1.6", "1.8"));
  EXPECT_EQ(label_ticks(0, 2e-4, 4).titled("contacts"), "contacts [10⁻⁶]");
  EXPECT_EQ(label_ticks(0, 5e3, 4).titled("x [m]"), "x [m]");
  EXPECT_EQ(label_ticks(0, 5e4, 4).titled("x [m]"), "x [10³ m]");
  EXPECT_EQ(label_ticks(-6e3, 0, 4).titled("v"), "v [10³]");
  const TickLabels fine = label_ticks(0.0489, 0.049, 4);
  EXPECT_EQ(fine.titled("y [m]"), "y [10⁻³ m]");
  EXPECT_EQ(fine.labels.back(), "49");
  EXPECT_EQ(label_ticks(0, 0.05, 5).titled("y [m]"), "y [m]") << "0.05 is short";
  // Places in kilometres are no shorter in powers of ten.
  const TickLabels far = label_ticks(12000, 12045, 5, Offset::of_large_numbers);
  EXPECT_EQ(far.axis_title("x [m]"), "x − 12000 [m]");
}
// The other axis has an offset.
TEST(Ticks, HaveAnOffsetInsteadOfAPowerOfTen) {
  const TickLabels power = label_ticks(350000, 350010, 2);
  EXPECT_THAT(power.labels, ElementsAre("350", "350.005", "350.01"));
  const TickLabels offset = label_ticks(350000, 350010, 2, Offset::of_large_numbers);
  EXPECT_THAT(offset.labels, ElementsAre("0", "5", "10"));
  EXPECT_EQ(offset.axis_title("x [m]"), "x − 350000 [m]");
  const TickLabels near = label_ticks(0, 10, 2, Offset::of_large_numbers);
  EXPECT_THAT(near.labels, ElementsAre("0", "5", "10"));
  EXPECT_EQ(near.axis_title("x [m]"), "x [m]");
}

TEST(Axes, TicksAreRoundNumbers) {
  EXPECT_THAT(nice_ticks(-0.3, 10.2, 5), ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_TRUE(nice_ticks(1, 1, 5).empty());
}

TEST(ValueRange, OfDecadesEndsAtPowersOfTen) {
  const ValueRange range = ValueRange::of_decades(1e-9, 9810.0, 4);
  EXPECT_DOUBLE_EQ(range.high, 1e4);
  EXPECT_DOUBLE_EQ(range.low, 1.0);
  EXPECT_DOUBLE_EQ(range.place(100.0), 0.5);
  EXPECT_EQ(range.place(0.0), 0.0);
  EXPECT_DOUBLE_EQ(ValueRange::of_decades(3.0, 9810.0, 9).low, 1.0);
  EXPECT_DOUBLE_EQ(ValueRange::of_decades(10.0, 10.0, 9).low, 1.0);  // one decade
  EXPECT_THAT(range.ticks(6).labels, ElementsAre("10⁰", "10¹", "10²", "10³", "10⁴"));
  EXPECT_THAT(range.ticks(3).labels, ElementsAre("10⁰", "10²", "10⁴"));
}

}  // namespace
}  // namespace blocks::draw
