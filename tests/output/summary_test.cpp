#include "output/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "sample_model.hpp"

namespace blocks::output {
namespace {

using nlohmann::json;
using samples::file_error;
using samples::TemporaryFolder;
using ::testing::HasSubstr;

RunReport report() {
  return {{"two.deck", "START\n", "Two blocks", "1.0.0", 1982},
          {"block 2 is thin"},
          1.5,
          "done",
          4};
}

TEST(Summary, HasTheValuesOfTheRun) {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  model.exits.push_back({1, 0.005});
  model.worst_overlap = 0.5;
  model.layers.push_back({1, 0, 2, 2, 1, 6, 3, 0});
  model.merges.push_back({1, 2, 3, 0.125, 0.2});
  write_summary(folder / "a.summary.json", model, report());
  const json summary = json::parse(samples::contents(folder / "a.summary.json"));
  EXPECT_EQ(summary["title"], "Two blocks");
  EXPECT_EQ(summary["seed"], 1982);
  EXPECT_EQ(summary["status"], "done");
  EXPECT_EQ(summary["steps"], 7);
  EXPECT_EQ(summary["dt"],
            json({{"value", 0.001}, {"block", 2}, {"limit", "contact"}}));
  EXPECT_EQ(summary["blocks"], 2);
  EXPECT_EQ(summary["corners"], 8);
  EXPECT_EQ(summary["contacts"], json({{"listed", 2}, {"active", 1}}));
  EXPECT_EQ(summary["kinetic_energy"],
            0.5 * 8 * 0.3125);  // The mass is 8, and v^2 = 0.3125.
  EXPECT_EQ(summary["momentum"], json({4.0, -2.0}));
  EXPECT_EQ(summary["worst_overlap"], json({{"end", 0.0625}, {"ever", 0.5}}));
  EXPECT_EQ(summary["fastest_block"]["block"], 2);
  EXPECT_EQ(summary["domain_exits"][0]["block"], 2);
  EXPECT_EQ(summary["merges"][0]["into"], 3);
  EXPECT_EQ(summary["layers"][0]["certificate"]["outline_edges"], 6);
  EXPECT_EQ(summary["warnings"], json({"block 2 is thin"}));
  EXPECT_EQ(summary["frames"], 4);
  EXPECT_EQ(summary["state_hash"], state_hash(model));
}

TEST(Summary, TellsWhetherAllSolveCardsHaveConverged) {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  const auto written = [&](std::optional<bool> solved) {
    RunReport done = report();
    done.solved = solved;
    write_summary(folder / "a.summary.json", model, done);
    return json::parse(samples::contents(folder / "a.summary.json"));
  };
  EXPECT_FALSE(written({}).contains("converged"));
  EXPECT_EQ(written(false)["converged"], false);  // stopped before its end
  model.solves = {{12, 1e-5, 8e-6, 100, 0.5, true, 0.0, -1, 1e-3, 0.0, -1}};
  EXPECT_EQ(written(true)["converged"], true);
  EXPECT_EQ(written(false)["converged"], false);
  EXPECT_EQ(written({})["converged"], true);  // a deck that continues this run
  model.solves.push_back(
      {14, 1e-5, 2e-5, 200, 1.5, false, 3.0, 1, 1e-3, 0.5, 1, 1e-4, 0.5, 3.0});
  const json summary = written(true);
  EXPECT_EQ(summary["converged"], false);
  EXPECT_EQ(summary["solves"][0]["largest_unbalanced"], nullptr);
  EXPECT_EQ(summary["solves"][0]["local_block"], nullptr);
  EXPECT_EQ(summary["solves"][0]["mass_scaling"], nullptr);
  EXPECT_EQ(summary["solves"][1],
            json({{"line", 14},
                  {"ratio", 1e-5},
                  {"reached", 2e-5},
                  {"converged", false},
                  {"steps", 200},
                  {"time", 1.5},
                  {"local", 1e-3},
                  {"reached_local", 0.5},
                  {"local_block", 2},
                  {"time_step", 1e-4},
                  {"mass_scaling", {{"least", 0.5}, {"largest", 3.0}}},
                  {"largest_unbalanced", {{"block", 2}, {"force", 3.0}}}}));
}

TEST(Summary, HasTheEnergyAccountIfItIsKept) {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  write_summary(folder / "a.summary.json", model, report());
  EXPECT_FALSE(
      json::parse(samples::contents(folder / "a.summary.json")).contains("energy"));
  model.energy.kept = true;
  model.energy.sums.assign(energy_entries, 0.0);
  model.energy.errors.assign(energy_entries, 0.0);
  model.energy.start = 5.0, model.energy.kinetic = 3.0;
  model.energy.add(EnergyEntry::gravity, 1.0);
  model.energy.add(EnergyEntry::friction, 2.5);
  write_summary(folder / "a.summary.json", model, report());
  const json energy =
      json::parse(samples::contents(folder / "a.summary.json"))["energy"];
  EXPECT_EQ(energy["start"], 5.0);
  EXPECT_EQ(energy["friction"], 2.5);
  EXPECT_EQ(energy["residual"], 0.5);
  EXPECT_EQ(energy["at_play"], 5.75);
}

// The run is unsound, and its title has an unknown encoding.
TEST(Summary, IsValidJsonAfterAnUnsoundRun) {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  model.blocks.velocity(0, 1) = std::numeric_limits<double>::quiet_NaN();
  RunReport unsound = report();
  unsound.identity.title = "caf\xE9";
  write_summary(folder / "a.json", model, unsound);
  const json summary = json::parse(samples::contents(folder / "a.json"));
  EXPECT_TRUE(summary["kinetic_energy"].is_null());
  write_summary(folder / "a.json", Model(), unsound);
  EXPECT_TRUE(
      json::parse(samples::contents(folder / "a.json"))["fastest_block"].is_null());
}

TEST(Summary, CannotBeWrittenIntoAMissingFolder) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      file_error([&] { write_summary(folder / "no/a.json", Model(), report()); }),
      HasSubstr("no/a.json: No such file or directory"));
}

TEST(StateHash, ChangesWithTheLastBitOfAnyCoordinateOrVelocity) {
  const Model model = samples::two_blocks();
  EXPECT_EQ(state_hash(model), state_hash(samples::two_blocks()));
  const auto changed = [&](auto&& change) {
    Model other = model;
    double& value = change(other.blocks);
    value = std::nextafter(value, 1e9);
    return state_hash(other) != state_hash(model);
  };
  EXPECT_TRUE(changed([](Blocks& b) -> double& { return b.corner(1, 7); }));
  EXPECT_TRUE(changed([](Blocks& b) -> double& { return b.centroid(0, 0); }));
  EXPECT_TRUE(changed([](Blocks& b) -> double& { return b.velocity(1, 1); }));
  EXPECT_TRUE(changed([](Blocks& b) -> double& { return b.spin[1]; }));
}

}  // namespace
}  // namespace blocks::output
