// The HISTORY card records quantities at exact multiples of its interval.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

#include "files/hdf5_handle.hpp"
#include "post/chart/history.hpp"
#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double dt = 0.0004;  // of the decks made by preliminary()

std::vector<post::RecordedHistory> recorded(const TemporaryFolder& folder,
                                            const std::string& name) {
  return post::ResultsReader((folder / (name + ".vtkhdf")).string()).recorded();
}

std::string fall(const std::string& cards) {
  return preliminary() + rectangle(0, 0, 1, 1) + "GRAVITY, 0, -10\n" + cards;
}

/// Returns the deck with the card before its first MOTION, CYCLE or SOLVE.
std::string with_card(std::string deck, const std::string& card) {
  const std::size_t at = std::min(deck.find("MOTION"), deck.find("CYCLE"));
  return deck.insert(at, card);
}

// After n steps y = y0 - g dt^2 n (n + 1) / 2 = y0 - g (t^2 + t dt) / 2, and a chord of
// a step is at most g dt^2 / 8 below this parabola.
TEST(HistoryCard, RecordsAFallAtExactMultiples) {
  const TemporaryFolder folder;
  run_text(folder, "fall", fall("HISTORY, 0.003, y:1\nMOTION, 0.1\n"));
  const auto sections = recorded(folder, "fall");
  ASSERT_EQ(sections.size(), 1U);
  const post::RecordedHistory& y = sections[0];
  EXPECT_EQ(y.interval, 0.003);
  EXPECT_THAT(y.quantities, ElementsAre("y:1"));
  ASSERT_EQ(y.time.size(), 34U);
  double worst = 0.0;
  for (std::size_t k = 0; k < y.time.size(); ++k) {
    const double t = y.time[k];
    EXPECT_EQ(t, std::stod(std::to_string(3 * k) + "e-3"));
    const double error =
        0.5 - 10 * (t * t + t * dt) / 2 - y.values(0, static_cast<Eigen::Index>(k));
    worst = std::max(worst, std::abs(error));
  }
  EXPECT_LE(worst, 10 * dt * dt / 8 + 1e-15);
  EXPECT_GT(worst, 0.0) << "no multiple was between two steps";
}

// Steps are at multiples of 0.0004, samples at multiples of 0.0001.
TEST(HistoryCard, InterpolatesAllMultiplesBetweenTwoSteps) {
  const TemporaryFolder folder;
  run_text(folder, "fall", fall("HISTORY, 0.0001, y:1\nPLOTS, 0.0004\nCYCLE, 20\n"));
  const post::RecordedHistory y = recorded(folder, "fall").at(0);
  const post::ResultsReader results((folder / "fall.vtkhdf").string());
  ASSERT_EQ(y.time.size(), 81U);
  for (long i = 0; i < 20; ++i) {
    const double before = results.frame(i).centroid(1, 0),
                 after = results.frame(i + 1).centroid(1, 0);
    EXPECT_EQ(y.values(0, 4 * i), before);
    for (int part = 1; part < 4; ++part)
      EXPECT_NEAR(y.values(0, 4 * i + part), before + part / 4.0 * (after - before),
                  1e-15);
  }
}

// If the interval is the time step, samples have the bits of the frames. The wall has
// an internal order.
TEST(HistoryCard, HasTheBitsOfFramesAtTheirTimes) {
  const std::string curves =
      "y:9, y:6-9, y:6-9:p90, vx:material=1:max, dx:12.2, displacement:3, overlap, "
      "normal_force:20-40, contacts, ke, fy:5, speed:p50, angular_momentum";
  const TemporaryFolder folder;
  run_text(folder, "wall", wall_at_random() + "CYCLE, 1\n");
  const double step = summary(folder, "wall")["dt"]["value"];
  run_text(folder, "wall",
           wall_at_random() +
               fmt::format("HISTORY, {}, {}\nPLOTS, {}\nSETVEL, 2, 40, 3, 1\n"
                           "CYCLE, 20\n",
                           step, curves, 5.0 * step));
  const post::ResultsReader results((folder / "wall.vtkhdf").string());
  const std::vector<post::Curve> asked = post::recorded_curves(results);
  ASSERT_EQ(asked.size(), 13U);
  const post::History frames = post::read_history({&results}, asked, {}, true),
                      samples = post::read_history({&results}, asked);
  ASSERT_EQ(frames.time.size(), 5U);
  ASSERT_EQ(samples.time.size(), 21U);
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t k = 0; k < asked.size(); ++k)
      EXPECT_EQ(samples.series[k].values[5 * i], frames.series[k].values[i])
          << asked[k].name() << " at " << frames.time[i];
}

TEST(HistoryCard, HasTheSameBitsForAnyNumberOfThreads) {
  const std::string deck = with_card(
      layers_and_loads, "HISTORY, 0.0007, ke, y:2-20, y:material=1:p10, overlap\n");
  const TemporaryFolder one, two;
  run_text(one, "layers", deck, "-j 1");
  run_text(two, "layers", deck, "-j 2");
  const auto of_one = stored(one / "layers.vtkhdf"),
             of_two = stored(two / "layers.vtkhdf");
  for (const char* column : {"BLOCKS/history/1/time", "BLOCKS/history/1/values"})
    EXPECT_EQ(of_one.at(column), of_two.at(column));
}

// Recording reads the state, which must not change it.
TEST(HistoryCard, DoesNotChangeTheRun) {
  const TemporaryFolder with, without;
  run_text(with, "layers",
           with_card(layers_and_loads, "HISTORY, 0.0007, ke, y:2-20, overlap\n"));
  run_text(without, "layers", layers_and_loads);
  EXPECT_EQ(summary(with, "layers")["state_hash"],
            summary(without, "layers")["state_hash"]);
  EXPECT_FALSE(stored(without / "layers.vtkhdf").contains("BLOCKS/history/1/values"));
}

TEST(HistoryCard, WithoutQuantitiesRecordsTheUsualOnes) {
  const TemporaryFolder folder;
  run_text(folder, "fall", fall("HISTORY, 0.01\nCYCLE, 30\n"));
  EXPECT_THAT(recorded(folder, "fall").at(0).quantities,
              ElementsAre("kinetic_energy", "overlap", "contacts"));
}

TEST(HistoryCard, RecordsManyQuantitiesOverARestart) {
  std::string quantities;
  for (const char* quantity : {"x", "y", "dx", "dy"})
    for (const char* place : {"1", "1.1", "1.2", "1.3", "1.4"})
      quantities += fmt::format(", {}:{}", quantity, place);
  const TemporaryFolder folder;
  const std::string deck = fall("HISTORY, 0.01" + quantities + "\nMOTION, 0.1\n");
  run_text(folder, "fall", deck, "--until 0.05");
  run_text(folder, "fall", deck, "--restart " + (folder / "fall.ckpt.h5").string());
  const auto sections = recorded(folder, "fall");
  ASSERT_EQ(sections.size(), 1U);
  EXPECT_EQ(sections[0].values.rows(), 20);
  EXPECT_EQ(sections[0].values.cols(),
            static_cast<Eigen::Index>(sections[0].time.size()));
}

// A run that ends at a multiple has a sample there, whatever the rounding of the sum.
TEST(HistoryCard, HasASampleAtTheEnd) {
  const TemporaryFolder folder;
  run_text(folder, "fall", fall("HISTORY, 0.1, step\nMOTION, 1\n"));
  const post::RecordedHistory step = recorded(folder, "fall").at(0);
  EXPECT_EQ(step.time.size(), 11U);
  EXPECT_EQ(step.time.back(), 1.0);
  EXPECT_NEAR(step.values(0, 10), 2500, 1e-6);
}

TEST(HistoryCard, ReplacesAnEarlierOneFromItsPlaceOn) {
  const TemporaryFolder folder;
  run_text(folder, "fall",
           fall("HISTORY, 0.01, y:1, ke\nMOTION, 0.1\nHISTORY, 0.02, ke\n"
                "MOTION, 0.1\n"));
  const auto sections = recorded(folder, "fall");
  ASSERT_EQ(sections.size(), 2U);
  EXPECT_EQ(sections[0].time.back(), 0.1);
  EXPECT_THAT(sections[1].quantities, ElementsAre("kinetic_energy"));
  EXPECT_EQ(sections[1].time.front(), 0.1);
  EXPECT_EQ(sections[1].time.back(), 0.2);
  const post::ResultsReader results((folder / "fall.vtkhdf").string());
  const post::History ke =
      post::read_history({&results}, {quantities::parse_curve("ke")});
  EXPECT_EQ(ke.time.size(), 11U + 5U) << "the second section begins at the same time";
}

TEST(HistoryCard, NamesMaterialsByNumberOrName) {
  const TemporaryFolder folder;
  std::string deck = fall("HISTORY, 0.01, y:material=sandstone, y:material=1\n"
                          "CYCLE, 30\n");
  const std::string card = "MATERIAL, 1,";
  const std::size_t end = deck.find('\n', deck.find(card));
  run_text(folder, "fall", deck.insert(end, ", sandstone"));
  const post::RecordedHistory y = recorded(folder, "fall").at(0);
  EXPECT_GT(y.time.size(), 1U);
  EXPECT_EQ(y.values.row(0), y.values.row(1));
}

// A RESTART deck keeps the request. Behind the results of the checkpoint the section
// goes on; other results begin with the state of the checkpoint.
TEST(HistoryCard, IsKeptByRestart) {
  const TemporaryFolder folder;
  run_text(folder, "fall", fall("HISTORY, 0.01, dy:1\nMOTION, 0.105\n"));
  const std::string more = "RESTART, fall.ckpt.h5\nMOTION, 0.1\nSTOP\n";
  run_text(folder, "more", more, "-o fall");
  run_text(folder, "whole", fall("HISTORY, 0.01, dy:1\nMOTION, 0.105\nMOTION, 0.1\n"));
  EXPECT_EQ(stored(folder / "fall.vtkhdf").at("BLOCKS/history/1/values"),
            stored(folder / "whole.vtkhdf").at("BLOCKS/history/1/values"));
  run_text(folder, "fall", fall("HISTORY, 0.01, dy:1\nMOTION, 0.1\n"));
  run_text(folder, "more", more);
  const post::RecordedHistory dy = recorded(folder, "more").at(0);
  EXPECT_EQ(dy.time.front(), 0.1);
  EXPECT_EQ(dy.time.back(), 0.2);
  EXPECT_EQ(dy.values(0, 0), 0.0) << "displacements from the first frame of the file";
}

TEST(HistoryCard, RefusesAnIntervalFarBelowTheStep) {
  const TemporaryFolder folder;
  folder.write("fall.deck", fall("HISTORY, 1.E-8, y:1\nCYCLE, 3\n"));
  const Outcome run = blocks("run fall.deck", folder.path());
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("HISTORY: an interval of 1e-08 is less than a "
                                 "thousandth of the time step, 0.0004"));
}

TEST(HistoryCommand, PrefersWhatWasRecorded) {
  const TemporaryFolder folder;
  run_text(folder, "fall", fall("HISTORY, 0.01, ke, y:1\nMOTION, 0.05\n"));
  const auto csv = [&](const std::string& more) {
    return blocks("history fall.vtkhdf --csv " + more, folder.path());
  };
  EXPECT_THAT(csv("").out, HasSubstr("time,kinetic_energy,y:1\n0,0,0.5\n0.01,"));
  EXPECT_THAT(csv("-q y:1 --from 0.02 --to 0.03").out, HasSubstr("y:1\n0.02,"));
  EXPECT_THAT(csv("-q y:1").out, HasSubstr("\n0.03,"));
  EXPECT_THAT(csv("-q y:1 --frames").out, ::testing::Not(HasSubstr("\n0.03,")));
  EXPECT_EQ(csv("-q y:1").err, "");
  EXPECT_EQ(csv("-q x:1").err, "") << "nothing that is asked for was recorded";
  EXPECT_EQ(
      csv("-q x:1,y:1").err,
      "blocks history: the curves of fall.vtkhdf are those of its frames: x:1 was "
      "not recorded\n");
}

// Blocks hang in the air between two fixed ones, so that stress changes its sign.
TEST(HistoryCommand, TurnsTheSignOfRecordedStresses) {
  const TemporaryFolder folder;
  run_text(folder, "fall",
           fall("HISTORY, 0.002, a22:1, a22:max\nPLOTS, 0.002\nMOTION, 0.02\n" +
                rectangle(-1, -3, 2, -2, true) + "MOTION, 0.8\n"));
  const auto values = [&](const std::string& curve, bool compression, bool frames) {
    post::ResultsReader results((folder / "fall.vtkhdf").string());
    if (compression)
      results.make_compression_positive();
    return post::read_history({&results}, {quantities::parse_curve(curve)}, {}, frames);
  };
  const auto as_it_is = values("a22:1", false, false),
             turned = values("a22:1", true, false);
  bool any = false;
  for (std::size_t i = 0; i < as_it_is.time.size(); ++i) {
    EXPECT_EQ(as_it_is.series[0].values[i], -turned.series[0].values[i]);
    any = any || as_it_is.series[0].values[i] != 0.0;
  }
  EXPECT_TRUE(any) << "there was no stress";
  // The largest compression is that of the frames, because it is not recorded.
  EXPECT_EQ(values("a22:max", true, false).time, values("a22:max", true, true).time);
}

// The parts of a run are joined where the second one begins. Displacements of the parts
// have different origins, so they are those of frames.
TEST(HistoryCommand, JoinsTheSamplesOfParts) {
  const TemporaryFolder folder;
  run_text(folder, "fall", fall("HISTORY, 0.01, y:1, dy:1\nMOTION, 0.105\n"));
  run_text(folder, "more", "RESTART, fall.ckpt.h5\nMOTION, 0.1\nSTOP\n");
  const post::ResultsReader begin((folder / "fall.vtkhdf").string()),
      end((folder / "more.vtkhdf").string());
  const auto joined = [&](const std::string& curve) {
    return post::read_history({&begin, &end}, {quantities::parse_curve(curve)});
  };
  ASSERT_EQ(joined("y:1").time.size(), 21U);
  for (int k = 0; k <= 20; ++k)
    EXPECT_EQ(joined("y:1").time[static_cast<std::size_t>(k)], k / 100.0);
  EXPECT_EQ(joined("dy:1").time.size(), 3U);
}

TEST(HistoryCommand, KnowsMaterialsByNumberAndName) {
  const TemporaryFolder folder;
  run_text(folder, "fall", fall("HISTORY, 0.01, y:material=1\nMOTION, 0.05\n"));
  const post::ResultsReader results((folder / "fall.vtkhdf").string());
  const auto times = [&](bool frames) {
    return post::read_history({&results}, {quantities::parse_curve("y:material=old")},
                              {}, frames, {{"old", 1}})
        .time.size();
  };
  EXPECT_EQ(times(false), 6U);
  EXPECT_EQ(times(true), 2U);
}

// Blocks of sandstone and units are those of the deck.
TEST(HistoryCommand, ConvertsSamplesAndKnowsTheNamesOfTheDeck) {
  const TemporaryFolder folder;
  std::string deck = fall("HISTORY, 0.01, y:material=sandstone, ke\nMOTION, 0.05\n");
  deck.insert(deck.find("END"), "UNITS, m, kg, s\n");
  deck.insert(deck.find('\n', deck.find("MATERIAL, 1,")), ", sandstone");
  run_text(folder, "fall", deck);
  for (const char* asked : {"y:material=1", "y:material=sandstone"}) {
    const Outcome csv =
        blocks("history fall.vtkhdf --csv --units mm,kg,ms -q " + std::string(asked),
               folder.path());
    EXPECT_THAT(csv.out, HasSubstr("\n0,500\n10,")) << csv.out << csv.err;
  }
}

/// Results whose group of samples is changed by a test.
class DamagedHistory : public ::testing::Test {
 protected:
  void SetUp() override {
    run_text(folder_, "fall", fall("HISTORY, 0.01, ke, y:1\nMOTION, 0.05\n"));
  }
  template <class Change> void damage(const Change& change) const {
    const auto file = hdf5::open_file((folder_ / "fall.vtkhdf").string(), true);
    change(hdf5::open_group(file.get(), "BLOCKS/history/1").get());
  }
  Outcome read() const { return blocks("history fall.vtkhdf", folder_.path()); }
  Outcome resume() const {
    return blocks("run fall.deck --restart fall.ckpt.h5", folder_.path());
  }
  TemporaryFolder folder_;
};

TEST_F(DamagedHistory, IsRefused) {
  for (const std::int64_t rows : {std::int64_t{-1}, std::int64_t{1} << 60}) {
    damage([&](hid_t group) { hdf5::write_attribute(group, "rows", rows); });
    for (const Outcome& outcome : {read(), resume()}) {
      EXPECT_EQ(outcome.code, 5) << rows;
      EXPECT_THAT(outcome.err, HasSubstr("fall.vtkhdf: ")) << rows;
    }
  }
}

TEST_F(DamagedHistory, WithoutAColumnIsRefused) {
  damage([](hid_t group) { H5Ldelete(group, "values", H5P_DEFAULT); });
  EXPECT_EQ(read().code, 5);
  EXPECT_THAT(read().err, HasSubstr("cannot read fall.vtkhdf: "));
  EXPECT_EQ(resume().code, 5);
}

TEST_F(DamagedHistory, ThatLacksSamplesIsNotContinued) {
  damage([](hid_t group) { hdf5::write_attribute(group, "rows", 2); });
  EXPECT_EQ(read().code, 0);
  const Outcome resumed = resume();
  EXPECT_EQ(resumed.code, 5);
  EXPECT_THAT(resumed.err, HasSubstr("cannot continue fall.vtkhdf: it has 2 samples of "
                                     "HISTORY, but 6 were written before the "
                                     "checkpoint"));
}

}  // namespace
}  // namespace blocks::testing
