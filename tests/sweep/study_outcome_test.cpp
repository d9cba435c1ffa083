#include "sweep/study_outcome.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "study/study.hpp"

namespace blocks::sweep {
namespace {

using nlohmann::ordered_json;

/// The values of one quantity in all frames in which it was measured.
std::vector<double> values(const std::vector<ordered_json>& frames,
                           const std::string& variant, const std::string& name) {
  std::vector<double> all;
  for (const ordered_json& frame : frames)
    if (const ordered_json& value = frame.at(variant).at(name); !value.is_null())
      all.push_back(value.get<double>());
  return all;
}

double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (const double value : values)
    total += value;
  return total;
}

/// Compares the frames first, first + 1, ... of a scene with the rows of the study.
void expect_the_rows_of_the_study(const std::string& scene, int first, int count) {
  SCOPED_TRACE(scene);
  const std::vector<std::string> variants = {"default", "report", "rounded"};
  study::StudyChoice choice;
  choice.frames.seed = 5;
  choice.first = first;
  choice.count = count;
  std::vector<ordered_json> frames;
  for (const std::string& name : variants)
    choice.variants.push_back(study::find_variant(name));
  for (int f = first; f < first + count; ++f)
    frames.push_back(study_outcome(scene, f, 5, variants));
  const study::Study study = study::run_study(study::make_scene(scene), choice);
  for (const study::Row& row : study.rows) {
    const std::string variant(row.variant->name);
    SCOPED_TRACE(variant);
    const auto expect_mean = [&](const std::string& name, const study::Estimate& mean) {
      const std::vector<double> all = values(frames, variant, name);
      if (all.empty()) {
        EXPECT_TRUE(std::isnan(mean.value)) << name;
      } else {
        EXPECT_EQ(sum(all) / static_cast<double>(all.size()), mean.value) << name;
      }
    };
    EXPECT_EQ(sum(values(frames, variant, "hung")), static_cast<double>(row.hung));
    EXPECT_EQ(sum(values(frames, variant, "fell")), static_cast<double>(row.fell));
    EXPECT_EQ(sum(values(frames, variant, "could_hang")) > 0,
              !std::isnan(row.hang_ups.value));
    expect_mean("wrong_signs", row.wrong_signs);
    expect_mean("wrong_tangents", row.wrong_tangents);
    expect_mean("phantom", row.phantom);
    expect_mean("missed", row.missed);
    expect_mean("speed_lost", row.speed_lost);
    expect_mean("energy_error", row.energy);
    EXPECT_EQ(sum(values(frames, variant, "diverged")),
              static_cast<double>(row.diverged));
    const auto steps = values(frames, variant, "diverged_step");
    EXPECT_EQ(steps.size(), static_cast<std::size_t>(row.diverged));
    if (!steps.empty()) {
      EXPECT_EQ(study::median(steps).value, row.divergence_step.value);
    }
    EXPECT_EQ(frames.front()["steps"], study.steps);
  }
}

// These scenes have hang-ups, blocks that rest, other blocks in each frame, and
// variants that differ from the default.
TEST(StudyOutcome, FramesAddUpToTheRowsOfTheStudy) {
  expect_the_rows_of_the_study("figure4b", 3, 7);
  expect_the_rows_of_the_study("stake", 0, 7);
  expect_the_rows_of_the_study("stack", 0, 3);
  expect_the_rows_of_the_study("triangles", 0, 7);
}

TEST(StudyOutcome, IsTheSameInEveryCall) {
  EXPECT_EQ(study_outcome("toe", 11, 1982, {"default"}).dump(),
            study_outcome("toe", 11, 1982, {"default"}).dump());
  EXPECT_NE(study_outcome("toe", 11, 1982, {"default"}).dump(),
            study_outcome("toe", 12, 1982, {"default"}).dump());
}

TEST(StudyOutcome, NamesUnknownWords) {
  EXPECT_THROW(study_outcome("steak", 0, 1, {"default"}), std::out_of_range);
  EXPECT_THROW(study_outcome("stake", 0, 1, {"defolt"}), std::out_of_range);
}

}  // namespace
}  // namespace blocks::sweep
