// The effect of each card on results and listing, tested with small decks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Runs cards after the preliminary cards of a rigid problem.
class CardsAtWork : public ::testing::Test {
 protected:
  void run(const std::string& cards) {
    run_text(folder_, "small", preliminary() + cards + "STOP\n");
    results_ =
        std::make_unique<post::ResultsReader>((folder_ / "small.vtkhdf").string());
    listing_ = slurp(folder_ / "small.out");
    json_ = summary(folder_, "small");
  }
  post::Frame first() const { return results_->frame(0); }
  post::Frame last() const { return results_->frame(results_->frames() - 1); }

  TemporaryFolder folder_;
  std::unique_ptr<post::ResultsReader> results_;
  std::string listing_;
  nlohmann::json json_;
};

/// Returns the block numbers in the rows of the first table after each OUTPUT heading.
std::vector<std::vector<int>> output_rows(const std::string& listing) {
  std::vector<std::vector<int>> tables;
  std::istringstream in(listing);
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("OUTPUT    time")) {
      tables.emplace_back();
      inside = true;
    } else if (line.empty()) {
      inside = false;
    } else if (int block = 0; inside && std::istringstream(line) >> block) {
      tables.back().push_back(block);
    }
  }
  return tables;
}

/// Counts how often `what` occurs in the text.
int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++found;
  return found;
}

const std::string four_squares = "CLOOP, 4, 3, 0.5\nCREATE, 4, 1\n-6, -6, -5, -5\n"
                                 "0, 1, 1, 0\n";

// The plane is elastic and has no friction. The speed changes by at most the order
// (w dt)^2 = 0.0016, because the last step of a contact ends after it has opened.
TEST_F(CardsAtWork, SplaneReflectsABlock) {
  run(rectangle(0.5, 0, 1.5, 1) + "SPLANE, 0, 9, 0, -9\nFRICTN, 0.9\n"
                                  "SETVEL, 1, 0, -2, 0.25\nMOTION, 1\n");
  EXPECT_NEAR(last().velocity(0, 0), 2.0, 2.0 * 0.0016);
  EXPECT_NEAR(last().velocity(1, 0), 0.25, 1e-12);
  EXPECT_NEAR(last().spin[0], 0.0, 1e-12);
  EXPECT_GT(last().centroid(0, 0), 0.5);
}

// Under a constant acceleration the integrator gives v = n g dt, x = g dt^2 n (n + 1)
// / 2.
TEST_F(CardsAtWork, GravityAcceleratesEveryFreeBlock) {
  run(rectangle(0, 0, 1, 1) + rectangle(5, 0, 6, 1) + rectangle(-5, 0, -4, 1, true) +
      "GRAVITY, 1, -10\nCYCLE, 100\n");
  const double dt = 0.0004, n = 100;
  for (const int b : {0, 1}) {
    EXPECT_NEAR(last().velocity(0, b), n * dt, 1e-12);
    EXPECT_NEAR(last().velocity(1, b), -10 * n * dt, 1e-12);
    EXPECT_NEAR(last().centroid(1, b), 0.5 - 5 * dt * dt * n * (n + 1), 1e-12);
  }
  EXPECT_EQ(last().centroid(1, 2), 0.5);
}

// FIX stops a moving block, and SETVEL after FIX has no effect.
TEST_F(CardsAtWork, FixHoldsABlock) {
  run(rectangle(0, 0, 1, 1) + rectangle(5, 0, 6, 1) +
      "GRAVITY, 0, -10\nSETVEL, 1, 2, 1, 1, 1\nFIX, 1\nSETVEL, 1, 0, 3, 3\n"
      "MOTION, 0.1\n");
  EXPECT_EQ(last().fixed, (std::vector<int>{1, 0}));
  EXPECT_EQ(last().velocity.col(0), Eigen::Vector2d(0, 0));
  EXPECT_EQ(last().centroid.col(0), Eigen::Vector2d(0.5, 0.5));
  EXPECT_EQ(last().spin[0], 0.0);
  EXPECT_NE(last().velocity(1, 1), 0.0);
}

// With nb2 = 0 the card selects one block, nb2 > nb1 a range, and nb2 < 0 all present
// blocks from nb1.
TEST_F(CardsAtWork, SetvelActsOnARangeOfBlocks) {
  run(four_squares +
      "SETVEL, 1, 2, 1, 0, 0.5\nSETVEL, 3, -1, 2, 0, 0\n"
      "SETVEL, 2, 0, 3, 0, 0\n" +
      rectangle(8, -8, 9, -7) + "CYCLE, 1\n");
  const Eigen::VectorXd speed = first().velocity.row(0).transpose();
  EXPECT_EQ(speed, (Eigen::VectorXd(5) << 1, 3, 2, 2, 0).finished());
  EXPECT_EQ(first().spin[0], 0.5);
  EXPECT_EQ(first().spin[1], 0.0);
}

// The card acts on the blocks of the material that precede it.
TEST_F(CardsAtWork, SetvelmActsOnBlocksOfAMaterial) {
  run(rectangle(0, 0, 1, 1) + "CREATE, 4, 2\n5, 5, 6, 6\n0, 1, 1, 0\n"
                              "SETVELM, 2, 0, 1, 0.25\n"
                              "CREATE, 4, 2\n-5, -5, -4, -4\n0, 1, 1, 0\nCYCLE, 1\n");
  EXPECT_EQ(first().material, (std::vector<int>{1, 2, 2}));
  EXPECT_EQ(first().velocity.row(1), (Eigen::RowVectorXd(3) << 0, 1, 0).finished());
  EXPECT_EQ(first().spin[1], 0.25);
}

// CLOOP makes n blocks in total. The first one is at the place of the CREATE card.
// A step load of a deck of 1982. A force of 1000 N on 1000 kg acts from t = 0.02 on.
TEST_F(CardsAtWork, FunctionWithEqualTimesIsAStep) {
  const std::string deck =
      preliminary("RIGID\nFUNCTION, 4\n0, 0\n.02, 0\n.02, 1\n1, 1\n") +
      rectangle(0, 0, 1, 1) + "FORCE, 1, 1000, 0\n";
  run_text(folder_, "a", deck + "MOTION, .02\n");
  folder_.write("b.deck", "RESTART, a.ckpt.h5\nMOTION, .02\n");
  EXPECT_EQ(blocks("run b.deck", folder_.path()).code, 0);
  const post::ResultsReader before((folder_ / "a.vtkhdf").string());
  EXPECT_EQ(before.frame(before.frames() - 1).velocity(0, 0), 0.0);
  const post::ResultsReader after((folder_ / "b.vtkhdf").string());
  EXPECT_NEAR(after.frame(after.frames() - 1).velocity(0, 0), 0.02, 1e-3);
  EXPECT_THAT(blocks("check a.deck", folder_.path()).out,
              HasSubstr("FUNCTION in line 14: a step from 0 to 1 at t = 0.02\n"));
}

TEST_F(CardsAtWork, CloopRepeatsABlockWithAShift) {
  run(four_squares + "CYCLE, 1\n");
  ASSERT_EQ(first().number.size(), 4U);
  for (int copy = 0; copy < 4; ++copy) {
    EXPECT_EQ(first().centroid(0, copy), -5.5 + 3 * copy);
    EXPECT_EQ(first().centroid(1, copy), 0.5 + 0.5 * copy);
  }
}

TEST_F(CardsAtWork, MergeRecordsTheAbsorbedBlocks) {
  run("MERGE, 0.7\nLAYER, -30, 1, -9,0, -9,1, 9,1, 9,0, RANDOM\nCYCLE, 1\n");
  const auto& merges = json_["merges"];
  ASSERT_GT(merges.size(), 0U);
  EXPECT_EQ(json_["blocks"].get<std::size_t>(), 30 - merges.size());
  for (const auto& merge : merges) {
    EXPECT_LT(merge["width_to_height"].get<double>(), 0.7);
    EXPECT_EQ(std::abs(merge["into"].get<int>() - merge["absorbed"].get<int>()), 1);
  }
  const auto at = listing_.find("MERGED BLOCKS");
  ASSERT_NE(at, std::string::npos);
  const auto table = listing_.substr(at, listing_.find("\n\n", at) - at);
  EXPECT_EQ(count(table, "\n") - 2, static_cast<int>(merges.size())) << table;
}

// Tables are printed at the start, at every interval and at the end.
TEST_F(CardsAtWork, OutputPrintsTheChosenBlocks) {
  run(four_squares + "OUTPUT, 0.1, 4, 2\nMOTION, 0.5\n");
  const auto tables = output_rows(listing_);
  ASSERT_EQ(tables.size(), 6U);
  for (const auto& rows : tables)
    EXPECT_THAT(rows, ElementsAre(4, 2));
}

TEST_F(CardsAtWork, StartAndEndArePrintedWithoutOutput) {
  run(four_squares + "MOTION, 0.5\n");
  EXPECT_THAT(output_rows(listing_),
              ElementsAre(ElementsAre(1, 2, 3, 4), ElementsAre(1, 2, 3, 4)));
}

// An interval has 250 steps. The sum of dt must neither lose nor repeat a frame.
TEST_F(CardsAtWork, PlotsWritesAFrameAtEachInterval) {
  run(four_squares + "PLOTS, 0.1\nMOTION, 0.5\n");
  ASSERT_EQ(results_->frames(), 6);
  for (long i = 0; i < 6; ++i)
    EXPECT_EQ(results_->frame(i).step, 250 * i);
}

// A step takes 0.0004. Times are in any order, and may be those of the interval.
TEST_F(CardsAtWork, PlotsWritesFramesAtListedTimes) {
  run(four_squares + "PLOTS, 0.2, 0.1001, 0.05, 0.2\nMOTION, 0.2\nMOTION, 0.1\n");
  std::vector<long> steps;
  for (long i = 0; i < results_->frames(); ++i)
    steps.push_back(results_->frame(i).step);
  EXPECT_THAT(steps, ElementsAre(0, 125, 250, 500, 750));
}

// The interval of the second PLOTS card begins at that card.
TEST_F(CardsAtWork, PlotsMayBeChangedDuringTheRun) {
  run(four_squares + "PLOTS, 0.2\nMOTION, 0.2\nPLOTS, 0.05\nMOTION, 0.1\n");
  std::vector<long> steps;
  for (long i = 0; i < results_->frames(); ++i)
    steps.push_back(results_->frame(i).step);
  EXPECT_THAT(steps, ElementsAre(0, 500, 625, 750));
}

// Both lower corners of the brick are in contact with the floor.
TEST_F(CardsAtWork, DumpPrintsTheContacts) {
  run(rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
      "GRAVITY, 0, -10\nDAMPING, 0.5\nMOTION, 0.2\nDUMP\n");
  EXPECT_EQ(count(listing_, "DUMP    time"), 1);
  const auto at = listing_.find("\nCONTACTS, ");
  ASSERT_NE(at, std::string::npos);
  const auto table = listing_.substr(at, listing_.find("\n\n", at + 1) - at);
  EXPECT_EQ(count(table, " yes "), 2) << table;
  EXPECT_EQ(count(table, " yes "), json_["contacts"]["active"].get<int>());
}

TEST_F(CardsAtWork, CycleAndMotionAddUp) {
  run(rectangle(0, 0, 1, 1) + "CYCLE, 7\nMOTION, 0.0041\nCYCLE, 1\n");
  EXPECT_EQ(json_["steps"], 7 + 11 + 1);
  EXPECT_NEAR(json_["time"].get<double>(), 19 * 0.0004, 1e-15);
}

TEST_F(CardsAtWork, DeckWithoutMotionWritesItsState) {
  run(four_squares);
  EXPECT_EQ(json_["steps"], 0);
  EXPECT_EQ(results_->frames(), 1);
}

TEST_F(CardsAtWork, DomainStopsABlockThatLeavesIt) {
  run(rectangle(8, 0, 9, 1) + "SETVEL, 1, 0, 4\nMOTION, 1\n");
  EXPECT_EQ(json_["domain_exits"].size(), 1U);
  EXPECT_NEAR(json_["domain_exits"][0]["time"].get<double>(), 0.25, 0.001);
  EXPECT_NEAR(last().centroid(0, 0), 9.5, 0.002);
  EXPECT_EQ(last().velocity(0, 0), 0.0);
  EXPECT_THAT(listing_, HasSubstr("block 1 left the domain at time 0.25"));
}

}  // namespace
}  // namespace blocks::testing
