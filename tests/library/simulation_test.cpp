// The library gives the same bits and messages as the program for the same cards.
#include "blocks/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

const std::string stack = preliminary() + rectangle(-2, -1, 3, 0, true) +
                          "CLOOP, 3, 0, 1\n" + rectangle(0, 0, 1, 1) +
                          "GRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.3\n";

/// Returns the corners of all blocks.
std::vector<double> corners(const Simulation& simulation) {
  std::vector<double> all;
  for (int b = 1; b <= simulation.blocks(); ++b) {
    const Eigen::Matrix2Xd of_block = simulation.corners(b);
    all.insert(all.end(), of_block.data(), of_block.data() + of_block.size());
  }
  return all;
}

TEST(Simulation, GivesTheBitsOfTheProgram) {
  const TemporaryFolder folder;
  const std::string push = "SETVEL, 3, 0, 1.5\n";
  folder.write("whole.deck", stack + "CYCLE, 200\n" + push + "CYCLE, 150\n");
  folder.write("first.deck", stack + "CYCLE, 200\n");
  ASSERT_EQ(blocks("run whole.deck", folder.path()).code, 0);
  ASSERT_EQ(blocks("run first.deck", folder.path()).code, 0);
  const auto state_of = [&](const std::string& name) {
    return corners(Simulation("RESTART, " + (folder / (name + ".ckpt.h5")).string()));
  };
  const std::vector<double> expected = state_of("whole");
  ASSERT_EQ(expected.size(), 32u);

  EXPECT_EQ(corners(Simulation::from_file(folder / "whole.deck", 2)), expected);

  Simulation driven(stack);
  for (int i = 0; i < 200; ++i)
    driven.step();
  driven.write_checkpoint(folder / "mid.ckpt.h5");
  driven.set_velocity(3, {1.5, 0.0});
  driven.step(150);
  EXPECT_EQ(corners(driven), expected);
  EXPECT_EQ(driven.steps(), 350);

  Simulation restarted("RESTART, " + (folder / "first.ckpt.h5").string());
  restarted.cards(push + "CYCLE, 150");
  EXPECT_EQ(corners(restarted), expected);

  folder.write("mid.deck", "RESTART, mid.ckpt.h5\n" + push + "CYCLE, 150\n");
  const Outcome back = blocks("run mid.deck -o back", folder.path());
  ASSERT_EQ(back.code, 0) << back.err;
  EXPECT_EQ(state_of("back"), expected);
}

// The blocks are numbered at random, so that the run uses an internal order.
TEST(Simulation, GivesTheBitsOfTheProgramInAnInternalOrder) {
  const TemporaryFolder folder;
  const std::string deck =
      wall_at_random() + "CYCLE, 12\nSETVEL, 77, 0, 1\nCYCLE, 8\n";
  folder.write("whole.deck", deck);
  ASSERT_EQ(blocks("run whole.deck -j 1", folder.path()).code, 0);
  const std::vector<double> expected =
      corners(Simulation("RESTART, " + (folder / "whole.ckpt.h5").string()));

  EXPECT_EQ(corners(Simulation(deck)), expected);
  Simulation driven(wall_at_random());
  for (int i = 0; i < 12; ++i)
    driven.step();
  driven.write_checkpoint(folder / "mid.ckpt.h5");
  driven.set_velocity(77, {1.0, 0.0});
  driven.step(8);
  EXPECT_EQ(corners(driven), expected);

  Simulation restarted("RESTART, " + (folder / "mid.ckpt.h5").string());
  restarted.cards("SETVEL, 77, 0, 1\nCYCLE, 8");
  EXPECT_EQ(corners(restarted), expected);
}

// Two calls would otherwise move an older checkpoint to .prev, and then delete it.
TEST(Simulation, KeepsCheckpointsThatItHasNotWritten) {
  const TemporaryFolder folder;
  folder.write("a.ckpt.h5", "mine");
  folder.write("a.ckpt.h5.prev", "mine, too");
  const auto read = [&](const char* name) { return slurp(folder / name); };
  Simulation first(stack);
  for (int i = 0; i < 3; ++i)
    first.write_checkpoint(folder / "a.ckpt.h5");
  EXPECT_EQ(read("a.ckpt.h5.bak"), "mine");
  EXPECT_EQ(read("a.ckpt.h5.prev.bak"), "mine, too");
  const std::string checkpoint = read("a.ckpt.h5");
  Simulation second(stack);
  second.write_checkpoint(folder / "a.ckpt.h5");
  EXPECT_EQ(read("a.ckpt.h5.bak"), "mine");
  EXPECT_EQ(read("a.ckpt.h5.bak2"), checkpoint);
}

// For every free block m dv = dt (contact forces + m g) in each step (1).
TEST(Simulation, HasTheContactForcesThatMoveTheBlocks) {
  Simulation simulation(stack);
  simulation.set_velocity(4, {0.4, -0.2}, 0.3);
  int contacts = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<Eigen::Vector2d> before;
    for (int b = 2; b <= simulation.blocks(); ++b)
      before.push_back(simulation.velocity(b));
    simulation.step();
    contacts += static_cast<int>(simulation.contacts().size());
    for (int b = 2; b <= simulation.blocks(); ++b) {
      const Eigen::Vector2d change = simulation.velocity(b) - before[b - 2];
      const double per_mass = simulation.time_step() / simulation.mass(b);
      const Eigen::Vector2d expected =
          per_mass * simulation.contact_force(b) +
          simulation.time_step() * Eigen::Vector2d(0.0, -9.81);
      double pressed = 0.0;
      for (const ContactForce& contact : simulation.contacts())
        if (contact.corner_block == b || contact.edge_block == b)
          pressed += contact.force().norm();
      // The tolerance covers round-off of velocities below 1. The normals have turned
      // by spin dt since the forces acted.
      EXPECT_LT((change - expected).norm(), 1e-14 + 1e-3 * per_mass * pressed);
    }
  }
  EXPECT_GT(contacts, 300);
}

// The velocity is changed as by a constant force. The integrator then gives
// x = F t (t + dt) / 2m.
TEST(Simulation, AcceleratesByAChangeOfVelocityInEveryStep) {
  Simulation simulation(preliminary() + rectangle(0, 0, 1, 1));
  const Eigen::Vector2d start = simulation.centroid(1), force(300.0, -200.0);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d change = simulation.time_step() / simulation.mass(1) * force;
    simulation.set_velocity(1, simulation.velocity(1) + change, simulation.spin(1));
    simulation.step();
  }
  const double t = simulation.time(), dt = simulation.time_step();
  const Eigen::Vector2d expected = 0.5 * t * (t + dt) / simulation.mass(1) * force;
  EXPECT_LT((simulation.centroid(1) - start - expected).norm(),
            1e-12 * expected.norm());
}

// A constant force gives x = F t (t + dt) / 2m. Without it the velocity stays.
TEST(Simulation, AcceleratesByAForceUntilItEnds) {
  Simulation simulation(preliminary() + rectangle(0, 0, 1, 1));
  const Eigen::Vector2d start = simulation.centroid(1), force(300.0, -200.0);
  simulation.set_force(1, {1.0, 1.0});
  simulation.set_force(1, force);
  simulation.step(100);
  const double t = simulation.time(), dt = simulation.time_step();
  const Eigen::Vector2d expected = 0.5 * t * (t + dt) / simulation.mass(1) * force;
  EXPECT_LT((simulation.centroid(1) - start - expected).norm(),
            1e-12 * expected.norm());
  simulation.set_force(1, {0.0, 0.0});
  const Eigen::Vector2d velocity = simulation.velocity(1);
  simulation.step(100);
  EXPECT_EQ(simulation.velocity(1), velocity);
  EXPECT_THROW(simulation.set_force(1, {NAN, 0.0}), std::invalid_argument);
  EXPECT_THROW(simulation.set_force(2, {1.0, 0.0}), std::out_of_range);
}

TEST(Simulation, TakesForcesAsTheCardDoesInAnInternalOrder) {
  std::string with_function = wall_at_random();
  with_function.insert(with_function.find("END\n"), "FUNCTION, 2\n0, 1\n9, 1\n");
  Simulation by_card(with_function), driven(wall_at_random());
  for (Simulation* one : {&by_card, &driven})
    one->step(10, false);
  by_card.cards("FORCE, 77, 1000, 500, 0");
  driven.set_force(77, {1000.0, 500.0});
  for (Simulation* one : {&by_card, &driven})
    one->step(10);
  EXPECT_EQ(corners(driven), corners(by_card));
}

TEST(Simulation, KnowsContactsOnlyOfStepsThatWereRead) {
  Simulation simulation(stack);
  EXPECT_TRUE(simulation.is_read() && simulation.contacts().empty());
  simulation.step(200);
  EXPECT_FALSE(simulation.contacts().empty());
  simulation.step(1, false);
  EXPECT_FALSE(simulation.is_read());
  EXPECT_THROW(simulation.contacts(), std::logic_error);
  EXPECT_THROW(simulation.contact_force(1), std::logic_error);
  simulation.step();
  EXPECT_FALSE(simulation.contacts().empty());
}

// The two lower corners of the block are on the plane.
TEST(Simulation, HasContactsWithSymmetryPlanes) {
  Simulation simulation(preliminary() + rectangle(0, 0, 1, 1) +
                        "SPLANE, 0, 0, 1, 0\nGRAVITY, 0, -9.81\nDAMPING, 0.4\n");
  simulation.step(3000);
  ASSERT_EQ(simulation.contacts().size(), 2u);
  for (const ContactForce& contact : simulation.contacts()) {
    EXPECT_EQ(contact.edge_block, 0);
    EXPECT_EQ(contact.edge, 1);
    EXPECT_EQ(contact.corner_block, 1);
    EXPECT_NEAR(contact.force().y(), 0.5 * 9.81 * simulation.mass(1),
                1e-6 * simulation.mass(1));
  }
}

// The messages are those of `blocks check`.
TEST(Simulation, ReportsEveryFaultOfTheCards) {
  try {
    Simulation simulation(stack + "FRICTN, -1\nSETVEL, 9\n");
    FAIL() << "accepted";
  } catch (const DeckError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cards:"));
    EXPECT_THAT(error.what(), HasSubstr("error: FRICTN: "));
    EXPECT_THAT(error.what(), HasSubstr("blocks 1 to 4 exist here"));
    EXPECT_THAT(error.what(), HasSubstr("2 errors"));
  }
}

TEST(Simulation, IsNotChangedByFaultyCards) {
  Simulation simulation(stack);
  const std::vector<double> before = corners(simulation);
  EXPECT_THROW(simulation.cards("FIX, 2\nFIX, 7\n"), DeckError);
  EXPECT_TRUE(simulation.is_free(2));
  try {
    simulation.cards("STIFF, 1e7, 1e7\n");
    FAIL() << "accepted";
  } catch (const DeckError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("cards:1:1: error: STIFF: a preliminary card cannot follow"));
  }
  EXPECT_EQ(corners(simulation), before);
}

TEST(Simulation, RefusesUnknownAndFixedBlocks) {
  Simulation simulation(stack);
  EXPECT_THROW(simulation.velocity(5), std::out_of_range);
  EXPECT_THROW(simulation.set_velocity(1, {0.0, 0.0}), std::logic_error);
}

TEST(Simulation, RefusesToBeginWithoutCheckpointOrBlocks) {
  EXPECT_THROW(Simulation("RESTART\n"), DeckError);
  EXPECT_THROW(Simulation("RESTART, absent.ckpt.h5\n"), std::runtime_error);
  EXPECT_THROW(Simulation(preliminary()).step(), std::logic_error);
}

TEST(Simulation, RefusesToContinueAnUnsoundRun) {
  Simulation thrown(preliminary() + rectangle(0, 0, 1, 1) +
                    rectangle(1.01, 0, 2.01, 1));
  thrown.set_velocity(1, {400.0, 0.0});
  EXPECT_THROW(thrown.step(10000), UnsoundRun);
  EXPECT_THROW(thrown.set_velocity(2, {std::nan(""), 1.0}), std::invalid_argument);
  const TemporaryFolder folder;
  const long made = thrown.steps();
  EXPECT_THROW(thrown.step(), UnsoundRun);
  EXPECT_THROW(thrown.step(0), UnsoundRun);
  EXPECT_THROW(thrown.cards("CYCLE, 1\n"), UnsoundRun);
  EXPECT_THROW(thrown.set_velocity(1, {0.0, 0.0}), UnsoundRun);
  EXPECT_THROW(thrown.write_checkpoint(folder / "bad.ckpt.h5"), UnsoundRun);
  EXPECT_EQ(thrown.steps(), made);
  try {
    thrown.step();
  } catch (const UnsoundRun& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot continue an unsound run: at time"));
  }
  thrown.write_frame(folder / "last.vtkhdf");
}

TEST(Simulation, SolvesInTheStepsOfARun) {
  const TemporaryFolder folder;
  const std::string deck = stack + "CYCLE, 33\nSOLVE, 1.E-4\n";
  run_text(folder, "a", deck);
  Simulation solved(deck);
  EXPECT_EQ(solved.steps(), summary(folder, "a")["steps"]);
  EXPECT_EQ(solved.unbalanced_ratio(), summary(folder, "a")["solves"][0]["reached"]);
  EXPECT_THAT(solved.warnings(), ::testing::IsEmpty());
  solved.cards("SOLVE, 1.E-14, 20\n");
  ASSERT_EQ(solved.warnings().size(), 1U);
  EXPECT_THAT(solved.warnings()[0], HasSubstr("SOLVE in line 1 has not converged"));
}

TEST(Simulation, RefusesAWrongNumberOfThreads) {
  EXPECT_THROW(Simulation(stack, 0), std::invalid_argument);
  EXPECT_THROW(Simulation(stack, 100000), std::invalid_argument);
}

TEST(Simulation, WritesSeveralResultsFiles) {
  const TemporaryFolder folder;
  Simulation driven(stack);
  for (int k = 0; k < 3; ++k) {
    driven.step(5);
    driven.write_frame(folder / "one.vtkhdf");
    driven.write_frame(folder / "two.vtkhdf");
  }
  for (const std::string name : {"one", "two"}) {
    const Outcome told =
        blocks("history " + name + ".vtkhdf -q kinetic_energy --csv", folder.path());
    EXPECT_EQ(std::count(told.out.begin(), told.out.end(), '\n'), 4) << told.out;
  }
}

// The second frame has a block that was made between two calls at the same time.
TEST(Simulation, WritesEachStateOnce) {
  const TemporaryFolder folder;
  Simulation driven(stack);
  const std::string file = folder / "w.vtkhdf";
  driven.write_frame(file);
  driven.write_frame(file);
  driven.cards(rectangle(0, 4, 1, 5));
  driven.write_frame((folder.path() / "." / "w.vtkhdf").string());
  EXPECT_FALSE(std::filesystem::exists(file + ".bak"));
  const Outcome told = blocks("history w.vtkhdf -q y:5 --csv", folder.path());
  EXPECT_EQ(std::count(told.out.begin(), told.out.end(), '\n'), 3) << told.out;
  EXPECT_THAT(told.out, HasSubstr("4.5")) << told.out;
}

TEST(Simulation, DoesNotWriteTheResultsOfAnotherSimulation) {
  const TemporaryFolder folder;
  Simulation driven(stack);
  const std::string file = folder / "w.vtkhdf";
  driven.write_frame(file);
  Simulation other(stack);
  try {
    other.write_frame(file);
    ADD_FAILURE() << "two Simulations write one file";
  } catch (const std::runtime_error& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("another Simulation writes its frames there"));
  }
  driven = Simulation(stack);
  other.write_frame(file);
  EXPECT_TRUE(std::filesystem::exists(file + ".bak"));
}

TEST(Simulation, WarnsOfOverlappingBlocks) {
  const Simulation simulation(stack + rectangle(0.5, 2.5, 1.5, 3.5));
  ASSERT_EQ(simulation.warnings().size(), 1u);
  EXPECT_THAT(simulation.warnings().front(), HasSubstr("blocks 4 and 5 overlap"));
}

TEST(Simulation, WarnsOfFastBlocksAndOfBlocksThatLeaveTheDomain) {
  Simulation thrown(preliminary() + rectangle(0, 0, 1, 1));
  thrown.set_velocity(1, {500.0, 0.0});
  thrown.step(100);
  ASSERT_EQ(thrown.warnings().size(), 2u);
  EXPECT_THAT(thrown.warnings()[0], HasSubstr("block 1 moved a corner by"));
  EXPECT_THAT(thrown.warnings()[1], HasSubstr("block 1 left the domain at time"));
  EXPECT_FALSE(thrown.is_free(1));
}

TEST(Simulation, NamesTheCardThatMakesTheTimeStepTooLarge) {
  const Simulation simulation(stack + "DAMPING, 0.9\nPLOTS, 1\n");
  ASSERT_EQ(simulation.warnings().size(), 1u);
  EXPECT_THAT(simulation.warnings().front(), HasSubstr("warning: DAMPING: FRACTION"));
}

}  // namespace
}  // namespace blocks::testing
