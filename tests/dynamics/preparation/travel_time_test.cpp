// How long a push takes through rows of blocks.
#include "dynamics/preparation/travel_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/rectangle.hpp"

namespace blocks::dynamics {
namespace {

using testing::rectangle;

constexpr double stiffness = 1e6, density = 1.0;

/// A row of unit squares from x = 0 on, and another one of two squares far away.
Model rows(int count, bool rigid = true) {
  Model model;
  Settings& settings = model.settings;
  settings.rigid = rigid;
  settings.normal_stiffness = settings.shear_stiffness = stiffness;
  settings.contact_tolerance = 0.01;
  settings.materials[0] = {1e9, 4e8, density};
  for (int i = 0; i < count; ++i)
    model.blocks.append({rectangle(i, 0, 1, 1)});
  model.blocks.append({rectangle(50, 0, 1, 1), rectangle(51, 0, 1, 1)});
  return model;
}

// Two squares touch with four corners.
TEST(TravelTime, IsThatOfTheLongestRow) {
  const double step = std::sqrt(density / (4 * stiffness));
  EXPECT_NEAR(longest_travel_time(rows(6)), 5 * step, 1e-12);
  EXPECT_NEAR(longest_travel_time(rows(1)), step, 1e-12);
}

TEST(TravelTime, EndsAtFixedBlocks) {
  Model model = rows(6);
  model.blocks.fix(2, Fixity::by_user);
  const double step = std::sqrt(density / (4 * stiffness));
  EXPECT_NEAR(longest_travel_time(model), 2 * step, 1e-12);
}

TEST(TravelTime, CountsContactsThatActAndTheBlocksThemselves) {
  Model model = rows(2);
  model.contacts.push_back({0, model.blocks.first_corner[1]});
  EXPECT_NEAR(longest_travel_time(model), std::sqrt(density / stiffness), 1e-12);
  EXPECT_GT(longest_travel_time(rows(6, false)), longest_travel_time(rows(6)));
}

}  // namespace
}  // namespace blocks::dynamics
