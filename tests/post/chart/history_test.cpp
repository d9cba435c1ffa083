// Histories and profiles have the numbers of the results file.
#include "post/chart/history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "post/chart/profile.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The deck of two squares that move towards each other, collide off centre and
/// separate.
const std::string collision = preliminary() + rectangle(0, 0, 1, 1) +
                              rectangle(1.02, 0.4, 2.02, 1.4) +
                              "SETVEL, 1, 0, 1\nSETVEL, 2, 0, -2\nPLOTS, 0.004\n"
                              "CYCLE, 100\n";

/// Reads the curves from the results NAME.vtkhdf.
post::History history(const TemporaryFolder& folder, const std::string& name,
                      const std::vector<std::string>& curves) {
  const post::ResultsReader results((folder / (name + ".vtkhdf")).string());
  std::vector<post::Curve> parsed;
  for (const std::string& text : curves)
    parsed.push_back(quantities::parse_curve(text));
  return post::read_history({&results}, parsed);
}

// By (1) to (3) v = -g dt n and y = y0 - g dt^2 n (n + 1) / 2.
TEST(History, OfAFallIsTheSumOfTheIntegrator) {
  const TemporaryFolder folder;
  run_text(folder, "fall",
           preliminary() + rectangle(0, 0, 1, 1) +
               "GRAVITY, 0, -10\nPLOTS, 0.004\nCYCLE, 100\n");
  const post::History fall = history(folder, "fall", {"VELY:1", "dy:1.3", "step"});
  ASSERT_GT(fall.time.size(), 9U);
  for (std::size_t i = 0; i < fall.time.size(); ++i) {
    const double n = fall.series[2].values[i], dt = 0.0004;
    EXPECT_NEAR(fall.series[0].values[i], -10 * dt * n, 1e-12);
    EXPECT_NEAR(fall.series[1].values[i], -5 * dt * dt * n * (n + 1), 1e-12);
  }
}

// The energy has the bits of the run. The collision conserves both momenta.
TEST(History, HasEnergyAndMomentaOfTheModel) {
  const TemporaryFolder folder;
  run_text(folder, "hit", collision);
  const post::ResultsReader results((folder / "hit.vtkhdf").string());
  const post::History hit = history(
      folder, "hit",
      {"kinetic_energy", "momentum_x", "angular_momentum", "contacts", "speed:max"});
  double max = 0.0;
  for (std::size_t i = 0; i < hit.time.size(); ++i) {
    const post::Frame frame = results.frame(static_cast<long>(i));
    EXPECT_EQ(hit.series[0].values[i], frame.kinetic_energy);
    EXPECT_NEAR(hit.series[1].values[i], hit.series[1].values[0], 1e-9);
    EXPECT_NEAR(hit.series[2].values[i], hit.series[2].values[0], 1e-9);
    EXPECT_EQ(hit.series[4].values[i], frame.velocity.colwise().norm().maxCoeff());
    max = std::max(max, hit.series[3].values[i]);
  }
  EXPECT_GT(max, 0.0) << "they never met";
}

// The block spins about its centroid, which is at rest.
TEST(History, OfACornerHasItsOwnSpeed) {
  const TemporaryFolder folder;
  run_text(folder, "spin",
           preliminary() + rectangle(0, 0, 2, 1) + "SETVEL, 1, 0, 0, 0, 3\nCYCLE, 1\n");
  const post::History spin =
      history(folder, "spin", {"speed:1", "speed:1.1", "rotation:1"});
  EXPECT_EQ(spin.series[0].values.back(), 0.0);
  EXPECT_NEAR(spin.series[1].values.back(), 3 * std::hypot(1, 0.5), 1e-12);
  EXPECT_NEAR(spin.series[2].values.back(), 3 * spin.time.back() * 180 / M_PI, 1e-12);
}

TEST(History, WritesTheBitsOfAllNumbersToCsv) {
  const TemporaryFolder folder;
  run_text(folder, "hit", collision);
  const Outcome csv = blocks("history hit.vtkhdf -q x:2,fx:1 --csv", folder.path());
  ASSERT_EQ(csv.code, 0) << csv.err;
  std::istringstream lines(csv.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "time,x:2,fx:1");
  const post::ResultsReader results((folder / "hit.vtkhdf").string());
  long i = 0;
  for (; std::getline(lines, line); ++i) {
    std::istringstream fields(line);
    std::string t, x, fx;
    std::getline(fields, t, ','), std::getline(fields, x, ',');
    std::getline(fields, fx, ',');
    const post::Frame frame = results.frame(i);
    EXPECT_EQ(std::stod(t), frame.time);
    EXPECT_EQ(std::stod(x), frame.centroid(0, 1));
    EXPECT_EQ(std::stod(fx), frame.force(0, 0));
  }
  EXPECT_EQ(i, results.frames());
}

TEST(History, WritesTheBitsOfAllNumbersToJson) {
  const TemporaryFolder folder;
  run_text(folder, "hit", collision);
  const post::ResultsReader results((folder / "hit.vtkhdf").string());
  const Outcome json = blocks("history hit.vtkhdf -q x:2 --json", folder.path());
  const auto column = nlohmann::json::parse(json.out)["runs"][0]["columns"][1];
  EXPECT_EQ(column["values"].back().get<double>(),
            results.frame(results.frames() - 1).centroid(0, 1));
}

TEST(History, TellsTheSignOfStressesInEveryFormat) {
  const TemporaryFolder folder;
  run_text(folder, "hit", collision);
  const auto printed = [&](const std::string& more) {
    return blocks("history hit.vtkhdf -q x:1,s22:1 " + more, folder.path()).out;
  };
  EXPECT_THAT(printed(""), HasSubstr("(hit.vtkhdf), stresses are tension positive\n"));
  EXPECT_THAT(printed("--csv"), StartsWith("time,x:1,s22:1 (tension positive)\n"));
  EXPECT_THAT(printed("--csv --compression-positive"),
              StartsWith("time,x:1,s22:1 (compression positive)\n"));
  const auto json = nlohmann::json::parse(printed("--json"))["runs"][0]["columns"];
  EXPECT_FALSE(json[1].contains("sign"));
  EXPECT_EQ(json[2]["sign"], "tension positive");
}

TEST(History, HasTheUnitsOfTheUser) {
  const TemporaryFolder folder;
  run_text(folder, "hit", collision);
  const auto table = [&](const std::string& more) {
    return blocks("history hit.vtkhdf -q speed:1,s11:1,fx:1 " + more, folder.path())
        .out;
  };
  EXPECT_THAT(table(""), HasSubstr("L T⁻¹"));
  EXPECT_THAT(table("--units m,kg,s"), HasSubstr("Pa"));
  EXPECT_THAT(table("--units cm,g,ms"), HasSubstr("g cm⁻¹ ms⁻²"));
}

TEST(History, NamesTheChoicesIfAnOptionIsWrong) {
  const TemporaryFolder folder;
  run_text(folder, "hit", collision);
  const auto expect_refusal = [&](const std::string& arguments, int code,
                                  const std::string& words) {
    const Outcome run = blocks("history " + arguments, folder.path());
    EXPECT_EQ(run.code, code) << arguments;
    EXPECT_THAT(run.err, HasSubstr(words)) << arguments;
  };
  expect_refusal("hit.vtkhdf --from nan", 2, "--from and --to need a number");
  expect_refusal("hit.vtkhdf --csv -o a.csv", 2, "remove one of them");
  std::filesystem::copy_file(folder / "hit.vtkhdf", folder / "hit.csv");
  expect_refusal("hit.csv -o hit.csv", 2, "would overwrite the results hit.csv");
  expect_refusal("hit.vtkhdf -q heat", 2, "speed, displacement, rotation");
  expect_refusal("hit.vtkhdf -q speed", 2, "speed:9 is that of block 9");
  expect_refusal("hit.vtkhdf -q speed:3", 2, "blocks 1 to 2, no block 3");
  expect_refusal("hit.vtkhdf -q x:1.5", 2, "corners 1 to 4, no corner 5");
  expect_refusal("hit.vtkhdf -q s11:1.2", 2, "a corner has no s11");
  expect_refusal("hit.vtkhdf -q x:1 --from 7", 2, "has times 0 to 0.04");
  expect_refusal("hit.vtkhdf --profile top -t 7", 2, "has times 0 to 0.04");
  expect_refusal("hit.vtkhdf --profile 5,5,6,6", 2,
                 "their centroids lie in x 0.5 to 1.52");
  expect_refusal("hit.vtkhdf -o hit.gif", 2, ".csv, .json, .png, .svg or .pdf");
}

TEST(History, NamesTheResultsOfTheFolderIfItCannotReadAFile) {
  const TemporaryFolder folder;
  run_text(folder, "hit", collision);
  folder.write("text.vtkhdf", "no results");
  const auto expect_refusal = [&](const std::string& arguments, int code,
                                  const std::string& words) {
    const Outcome run = blocks("history " + arguments, folder.path());
    EXPECT_EQ(run.code, code) << arguments;
    EXPECT_THAT(run.err, HasSubstr(words)) << arguments;
  };
  expect_refusal("hit.deck", 5, "cannot read hit.deck");
  expect_refusal("text.vtkhdf", 5,
                 "cannot read text.vtkhdf: it is not a results file of BLOCKS\n  hint: "
                 "results in this folder: "
                 "hit.vtkhdf\n");
  expect_refusal("none.vtkhdf", 5,
                 "cannot read none.vtkhdf: No such file or directory\n  hint: results "
                 "in this folder: "
                 "hit.vtkhdf\n");
  folder.write("empty.vtkhdf", "");
  expect_refusal("empty.vtkhdf", 5, "cannot read empty.vtkhdf: it is empty\n  hint: ");
  fs::create_directory(folder / "far");
  folder.write("far/text.vtkhdf", "no results");
  expect_refusal("far/text.vtkhdf", 5,
                 "hint: blocks run DECK writes results to NAME.vtkhdf");
}

TEST(History, WritesFiguresOfSeveralRuns) {
  const TemporaryFolder folder;
  run_text(folder, "hit", collision);
  run_text(folder, "again", collision);
  const std::string both =
      "history hit.vtkhdf again.vtkhdf -q speed:1,x:2 -o a.svg,a.png,a.csv";
  const Outcome figure = blocks(both, folder.path());
  ASSERT_EQ(figure.code, 0) << figure.err;
  EXPECT_THAT(slurp(folder / "a.svg"), HasSubstr("<svg"));
  EXPECT_THAT(slurp(folder / "a.csv"), HasSubstr("\nagain.vtkhdf,"));
}

TEST(History, KeepsOlderFigures) {
  const TemporaryFolder folder;
  run_text(folder, "hit", collision);
  for (const char* name : {"a.svg", "a.png", "a.csv"})
    folder.write(name, "mine");
  for (int i = 0; i < 2; ++i) {
    const Outcome figure =
        blocks("history hit.vtkhdf -q speed:1,x:2 -o a.svg,a.png,a.csv", folder.path());
    ASSERT_EQ(figure.code, 0) << figure.err;
  }
  for (const char* name : {"a.svg.bak", "a.png.bak", "a.csv.bak"})
    EXPECT_EQ(slurp(folder / name), "mine") << name;
  EXPECT_FALSE(folder.holds("a.svg.tmp"));
}

// The frame has two layers. The surface is the upper one, and a vertical line meets one
// block of each.
TEST(Profile, FindsTheBlocksOfTheSurfaceAndOfALine) {
  post::Frame frame;
  frame.centroid.resize(2, 6);
  for (int b = 0; b < 6; ++b) {
    const double x = b % 3, y = b / 3;  // NOLINT(bugprone-integer-division)
    frame.number.push_back(b + 1);
    frame.outlines.push_back({{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}});
    frame.centroid.col(b) << x + 0.5, y + 0.5;
  }
  const auto blocks_of = [&](const std::string& line) {
    std::vector<int> blocks;
    for (const auto& place :
         post::profile_places(frame, post::ProfileLine::parse(line)))
      blocks.push_back(place.block);
    return blocks;
  };
  EXPECT_EQ(blocks_of("top"), (std::vector{4, 5, 6}));
  EXPECT_EQ(blocks_of("1.5,5,1.5,-5"), (std::vector{5, 2}));
  EXPECT_EQ(blocks_of("0.5,0.5,9,0.5"), (std::vector{1, 2, 3}));
  EXPECT_EQ(
      post::profile_places(frame, post::ProfileLine::parse("-1,0.5,9,0.5"))[1].position,
      2.5);
}

// The mirror plane is at x = 1. Each place occurs once.
TEST(Profile, MirrorsPositionsAndVectorsOfAHalfModel) {
  post::Frame first, now;
  first.centroid.resize(2, 3);
  first.centroid << 1, 2, 3, 0, 0, 0;
  now = first;
  now.centroid.row(0).array() += 0.25;
  now.centroid.row(1).array() -= 0.5;
  const auto places = post::both_halves({{1, 1.0}, {2, 2.0}, {3, 3.0}}, 1.0);
  std::vector<double> positions;
  for (const auto& place : places)
    positions.push_back(place.position);
  EXPECT_EQ(positions, (std::vector<double>{-1, 0, 1, 2, 3}));
  const auto values = [&](const char* name) {
    return post::profile_values(places, *quantities::find_quantity(name), now, first);
  };
  EXPECT_EQ(values("dx"), (std::vector{-0.25, -0.25, 0.25, 0.25, 0.25}));
  EXPECT_EQ(values("dy"), (std::vector{-0.5, -0.5, -0.5, -0.5, -0.5}));
  EXPECT_EQ(values("x"), (std::vector{-1.25, -0.25, 1.25, 2.25, 3.25}));
}

}  // namespace
}  // namespace blocks::testing
