// WATER and JWATER in whole runs: effective weights, energy, restarts, threads,
// results.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "output/checkpoint/checkpoint.hpp"
#include "post/read/results_reader.hpp"
#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

const std::string walls = rectangle(-2, -2, 10, 0, true) +
                          rectangle(-1, 0, 0, 9, true) + rectangle(8, 0, 9, 9, true);
const std::string cut_rock = "OUTLINE, 4, 1\n0, 0, 8, 8\n0, 8, 8, 0\n"
                             "JSET, 1, 30, 5, 1.5, .3, 6, 2, .5, .2\n"
                             "JSET, 2, 110, 8, 1.5, .4, 5, 2, 1, .3\n"
                             "CUT, .1, .05\n"
                             "JOINT, 1, .5, , , , , , , , 1.E7\n"
                             "JOINT, 2, .5, , , , , , , , 1.E7\n";

std::string rock(const std::string& kind) {
  std::string deck = preliminary(kind) + walls + cut_rock;
  return deck.replace(deck.find("100, 6"), 6, "200, 40");
}

class WaterRuns : public ::testing::Test {
 protected:
  Model ran(const std::string& name, const std::string& deck,
            const std::string& more = {}) {
    run_text(folder_, name, deck, more);
    output::CheckpointInfo info;
    return output::read_checkpoint((folder_ / (name + ".ckpt.h5")).string(), info);
  }
  TemporaryFolder folder_;
};

/// Rock of density 1000 in water of density 400 moves as rock of its mass and 0.6 of
/// its weight, and its contacts bear that weight. Water presses deformable blocks
/// together, too, so only rigid ones are the same.
TEST_F(WaterRuns, DrownedRockHasItsEffectiveWeight) {
  for (const std::string damping : {"LOCDAMP, .7\n", "DAMPING, .5\n"}) {
    const Model wet = ran("wet", rock("RIGID\n") + damping +
                                     "GRAVITY, 0, -10\nWATER, 4000, 1\n0, 50\n"
                                     "CYCLE, 6000\n");
    const Model light =
        ran("light", rock("RIGID\n") + damping + "GRAVITY, 0, -6\nCYCLE, 6000\n");
    ASSERT_EQ(wet.contacts.size(), light.contacts.size());
    double largest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < wet.contacts.size(); ++i) {
      ASSERT_EQ(wet.contacts[i].corner, light.contacts[i].corner);
      largest = std::max(largest, wet.contacts[i].normal_force);
      difference = std::max(difference, std::abs(wet.contacts[i].normal_force -
                                                 light.contacts[i].normal_force));
    }
    EXPECT_GT(largest, 1e4);
    EXPECT_LT(difference, 1e-9 * largest) << damping;
  }
}

/// A block that water lifts: the force is constant below the table, and the work of the
/// water is that of its weight in place of the block, until the block floats.
TEST_F(WaterRuns, WorkOfWaterIsInTheEnergyAccount) {
  std::string deck = preliminary() + rectangle(0, 0, 2, 1) +
                     "GRAVITY, 0, -10\nWATER, 20000, 1\n0, 4\n"
                     "HISTORY, .05, energy:water, energy:residual, energy:integration, "
                     "energy:gravity, energy:kinetic, y:1, water_y:1\n";
  for (const double fraction : {0.02, 0.005}) {
    std::string finer = deck;
    finer.replace(finer.find("FRACTION, 0.02"), 14,
                  fmt::format("FRACTION, {}", fraction));
    run_text(folder_, "lift", finer + "MOTION, .6\n");
    const post::ResultsReader results((folder_ / "lift.vtkhdf").string());
    const auto recorded = results.recorded();
    ASSERT_EQ(recorded.size(), 1U);
    const auto& values = recorded[0].values;
    for (Eigen::Index i = 1; i < values.cols(); ++i) {
      const double water = values(0, i), height = values(5, i) - values(5, 0);
      EXPECT_NEAR(values(1, i), 0.0, 1e-9 * std::abs(water));
      if (values(5, i) < 3.4) {  // drowned
        EXPECT_NEAR(values(6, i), 40000.0, 1e-9);
        EXPECT_NEAR(water / (40000.0 * height), 1.0, 20.0 * fraction) << i;
      } else {
        EXPECT_LT(values(6, i), 40000.0);
      }
    }
    EXPECT_LT(std::abs(values(2, values.cols() - 1)), 0.5 * fraction * values(0, 1));
  }
}

/// Half of a dam beside a symmetry plane is the full one: the plane bears the effective
/// force only.
TEST_F(WaterRuns, PressesOnSymmetryPlanes) {
  const std::string water = "JOINT, 1, .5, , , , , , , , 1.E7\nJPAIR, 1, 1, 1\n"
                            "GRAVITY, 0, -10\nWATER, 4000, 2\n-5, 3\n5, 3\n"
                            "LOCDAMP, .7\nCYCLE, 3000\n";
  const Model half =
      ran("half", preliminary() + rectangle(-2, -2, 10, 0, true) +
                      rectangle(0, 0, 2, 1) + "SPLANE, 0, 5, 0, 0\n" + water);
  const Model full = ran("full", preliminary() + rectangle(-10, -2, 10, 0, true) +
                                     rectangle(-2, 0, 2, 1) + water);
  EXPECT_NEAR(half.blocks.centroid(1, 1), full.blocks.centroid(1, 1), 1e-9);
  EXPECT_NEAR(half.blocks.centroid(0, 1), 1.0, 1e-9);
  EXPECT_NEAR(2.0 * half.blocks.force(1, 1), full.blocks.force(1, 1), 1e-6);
}

const std::string rising_table =
    "GRAVITY, 0, -10\nWATER, 5000, 3, .5\n0, 2\n3, 6\n8, 5\n"
    "PLOTS, .1\nHISTORY, .01, energy:residual, energy:water, water_x:max\n";
const std::string moving_water =
    rising_table + "JWATER, 2, 0, 0, 2.E4, 8, 8, 0, 3, .2\n";

TEST_F(WaterRuns, RestartsAndThreadsHaveTheSameBits) {
  const std::string deck = rock("") + "LOCDAMP, .7\n" + moving_water;
  const Model whole = ran("whole", deck + "CYCLE, 900\n");
  const Model threads = ran("threads", deck + "CYCLE, 900\n", "--threads 3");
  ran("first", deck + "CYCLE, 400\n");
  run_text(folder_, "second", "RESTART, first\nCYCLE, 500\n");
  output::CheckpointInfo info;
  const Model second =
      output::read_checkpoint((folder_ / "second.ckpt.h5").string(), info);
  for (const Model* other : {&threads, &second}) {
    EXPECT_EQ(whole.blocks.corner, other->blocks.corner);
    EXPECT_EQ(whole.blocks.velocity, other->blocks.velocity);
    EXPECT_EQ(whole.energy.of(EnergyEntry::water),
              other->energy.of(EnergyEntry::water));
  }
  EXPECT_GT(std::abs(whole.energy.of(EnergyEntry::water)), 1.0);
  EXPECT_NEAR(whole.energy.residual(), 0.0, 1e-9 * whole.energy.at_play());
}

TEST_F(WaterRuns, AnAuditFindsTheForcesExact) {
  const Outcome run =
      run_text(folder_, "a", rock("") + "LOCDAMP, .7\n" + rising_table + "CYCLE, 900\n",
               "--audit=100");
  const auto audit = summary(folder_, "a")["audit"];
  EXPECT_EQ(audit["moments"], 9);
  EXPECT_TRUE(audit["faults"].empty());
  EXPECT_LT(audit["worst_water"]["error"].get<double>(), 1e-12);
  EXPECT_THAT(run.out + run.err, HasSubstr("largest error of a force of water"));
}

TEST_F(WaterRuns, ResultsHavePressuresForcesAndTheTable) {
  run_text(folder_, "a",
           preliminary() + rectangle(-5, -2, 10, 0, true) + rectangle(0, 0, 2, 2) +
               "GRAVITY, 0, -10\nPLOTS, .01\nMOTION, .02\n"
               "WATER, 4000, 2\n0, 1\n4, 3\nMOTION, .02\n");
  const post::ResultsReader results((folder_ / "a.vtkhdf").string());
  const post::Frame dry = results.frame(0);
  EXPECT_TRUE(dry.water_line.empty());
  const post::Frame wet = results.frame(results.frames() - 1);
  ASSERT_GE(wet.water_line.size(), 3U);
  EXPECT_LT(wet.water_line.front().x(), -5.0);
  EXPECT_NEAR(wet.water_line.front().y(), 1.0, 1e-15);
  // Side 1 is the left one, from below to above; side 4 is the base.
  std::map<int, post::WetSide> sides;
  for (const post::WetSide& side : wet.wet_sides)
    if (side.block == 1)
      sides[side.side] = side;
  ASSERT_GE(sides.size(), 3U);
  EXPECT_NEAR(sides[0].pressure[0], 4000.0, 20.0);
  EXPECT_EQ(sides[0].pressure[1], 0.0);
  EXPECT_NEAR(sides[0].share[1], 0.5, 0.01) << "the upper half is dry";
  EXPECT_NEAR(sides[3].pressure[0], 8000.0, 20.0);
  // By areas: the part of the block below the line from (0, 1) to (2, 2) is 3 m2.
  EXPECT_NEAR(wet.water_force(1, 1), 4000.0 * 3.0, 40.0);
  EXPECT_NEAR(wet.water_force(0, 1), -4000.0 * 0.5 * 3.0, 20.0);
  for (const char* colour : {"water_pressure", "water_y", "material"})
    EXPECT_EQ(blocks(fmt::format("plot a.vtkhdf --colour {} -o {}.svg", colour, colour),
                     folder_.path())
                  .code,
              0);
  EXPECT_THAT(slurp(folder_ / "water_pressure.svg"), HasSubstr("water table"));
  EXPECT_EQ(blocks("view a.vtkhdf", folder_.path()).code, 0);
  const Outcome none =
      blocks("plot a.vtkhdf -t 0 --colour water_pressure", folder_.path());
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("no water presses on a side at the times drawn"));
}

/// A driven block leaves a joint under water: the water follows into the open joint,
/// and beyond its shore the block is in air.
TEST_F(WaterRuns, FollowsIntoJointsThatOpenAndStaysBehindInTheRock) {
  run_text(folder_, "a",
           preliminary() + rectangle(-1, -2, 9, 0, true) +
               rectangle(-1, 0, 0, 2, true) + rectangle(0, 0, 1, 2, true) +
               "GRAVITY, 0, -10\nDRIVE, 3, 4, 0\nWATER, 5000, 3\n0, 2\n3, 2\n"
               "3.1, -1\nHISTORY, .01, x:3, water_x:3\nMOTION, 2\n");
  const post::ResultsReader results((folder_ / "a.vtkhdf").string());
  const auto& values = results.recorded().at(0).values;
  int opened = 0, beyond = 0;
  for (Eigen::Index i = 0; i < values.cols(); ++i) {
    const double left = values(0, i) - 0.5, force = values(1, i);
    if (left + 1.0 < 3.0) {
      EXPECT_NEAR(force, 0.0, 1e-9) << "the same water on both sides";
      opened += left > 0.1;
    } else if (left > 3.1) {
      EXPECT_EQ(force, 0.0);
      ++beyond;
    } else if (left + 1.0 > 3.1 && left < 3.0) {
      EXPECT_NEAR(force, 0.5 * 5000.0 * 4.0, 1e-9) << "water behind it, air before it";
    }
  }
  EXPECT_GT(opened, 10);
  EXPECT_GT(beyond, 10);
}

/// Every form of the cards leaves a checkpoint that can be read.
TEST_F(WaterRuns, CanStopAndGoOnWithEveryForm) {
  const std::string forms[] = {"WATER, , 0, .5\n",
                               "WATER, , 0\n",
                               "WATER, 5000, 1\n0, 1\nWATER, , 0, .01\n",
                               "WATER, 5000, 1, 9\n0, 1\n",
                               "JWATER, 0\n",
                               "JWATER, 0, , , , , , , , .01\n",
                               "JWATER, 0, 0, 0, 9, 0, 1, 0, , 5\n"};
  for (const std::string& form : forms) {
    folder_.write("a.deck", preliminary() + rectangle(0, 0, 1, 1) +
                                "GRAVITY, 0, -10\n" + form + "CYCLE, 100\n");
    EXPECT_EQ(blocks("run a.deck -q --stop-after 40", folder_.path()).code, 75) << form;
    const Outcome on = blocks("run a.deck -q --restart a.ckpt.h5", folder_.path());
    EXPECT_EQ(on.code, 0) << form << on.err;
    fs::remove(folder_ / "a.ckpt.h5");
  }
}

TEST_F(WaterRuns, WarningsNameWaterThatPressesOnNothing) {
  const auto said = [&](const std::string& cards) {
    folder_.write("a.deck",
                  preliminary() + rectangle(0, 0, 1, 1) + cards + "CYCLE, 9\n");
    return blocks("check a.deck", folder_.path()).err;
  };
  const std::string gravity = "GRAVITY, 0, -10\n";
  EXPECT_THAT(said(gravity + "WATER, 5000, 1\n0, -1\n"),
              HasSubstr("WATER: the table lies below all blocks"));
  EXPECT_THAT(said(gravity + "JWATER, 0, 5, 5, 9, 6, 6, 9\n"),
              HasSubstr("JWATER: no side of joint id 0 lies between the points"));
  EXPECT_THAT(said("GRAVITY, 0, -10, 1\nWATER, 5000, 1\n0, 1\n"),
              HasSubstr("blocks float first"));
  EXPECT_THAT(said(gravity + "WATER, 5000, 1\n0, 1\nGRAVITY, 5, -5\n"),
              HasSubstr("GRAVITY: depth below the water table is not measured along"));
  EXPECT_THAT(said(gravity + "WATER, 5000, 1, 99\n0, 1\n"),
              HasSubstr("the water table changes during 99"));
}

TEST_F(WaterRuns, ARampNeedsTheSameDirectionOfGravity) {
  folder_.write("a.deck", preliminary() + rectangle(0, 0, 1, 1) +
                              "GRAVITY, 0, -10\nWATER, 5000, 1\n0, 1\n"
                              "GRAVITY, 1, -10\nWATER, 5000, 1, .1\n0, 2\nCYCLE, 1\n");
  EXPECT_THAT(blocks("check a.deck", folder_.path()).err,
              HasSubstr("gravity has another direction than at the WATER card before"));
  folder_.write("b.deck", preliminary() + rectangle(0, 0, 1, 1) +
                              "GRAVITY, 10, -1\nWATER, 5000, 3\n0, 1\n1, 40\n2, 1\n"
                              "CYCLE, 1\n");
  EXPECT_THAT(
      blocks("check b.deck", folder_.path()).err,
      HasSubstr("the points of the table must follow each other across gravity"));
}

/// The same model in a frame turned by 30 degrees, gravity and table too.
TEST_F(WaterRuns, DepthIsMeasuredAlongGravity) {
  const double c = std::cos(0.5), s = std::sin(0.5);
  const auto turned = [&](double x, double y) {
    return fmt::format("{:.17g}, {:.17g}\n", c * x - s * y, s * x + c * y);
  };
  const auto block = [&](double left, double low, double right, double high,
                         int fixed) {
    std::string xs, ys;
    for (const auto& [x, y] :
         {std::pair{left, low}, {left, high}, {right, high}, {right, low}}) {
      xs += fmt::format("{}{:.17g}", xs.empty() ? "" : ", ", c * x - s * y);
      ys += fmt::format("{}{:.17g}", ys.empty() ? "" : ", ", s * x + c * y);
    }
    return fmt::format("CREATE, 4, 1, {}\n{}\n{}\n", fixed, xs, ys);
  };
  const std::string rest = "FRICTN, .5\nLOCDAMP, .5\nCYCLE, 500\n";
  const Model upright = ran("upright", preliminary() + rectangle(-2, -1, 4, 0, true) +
                                           rectangle(0, 0, 1, 2) +
                                           "GRAVITY, 0, -10\nWATER, 5000, 2\n-3, 1\n"
                                           "4, 1.5\n" +
                                           rest);
  const Model inclined =
      ran("inclined", preliminary() + block(-2, -1, 4, 0, 1) + block(0, 0, 1, 2, 0) +
                          fmt::format("GRAVITY, {:.17g}, {:.17g}\n", 10 * s, -10 * c) +
                          "WATER, 5000, 2\n" + turned(-3, 1) + turned(4, 1.5) + rest);
  const Vec2 one = upright.blocks.centroid.col(1),
             other = inclined.blocks.centroid.col(1);
  EXPECT_LT((Vec2(c * one.x() - s * one.y(), s * one.x() + c * one.y()) - other).norm(),
            1e-12);
}

}  // namespace
}  // namespace blocks::testing
