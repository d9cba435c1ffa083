// Awkward networks of joints, tests/corpus/networks/NAME.deck. The first lines of each
// deck say what makes it awkward. NAME.expected has the messages of `blocks check`, and
// for a deck without errors the numbers of blocks, area, and lengths of joints.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "run/run.hpp"
#include "tests/geometry/area_judge.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using geometry::Polygon;
using geometry::Vec2;

const char* const corpus = "tests/corpus/networks";

std::string outcome_of(const Model& model) {
  double area = 0.0;
  std::string cuts;
  for (const CutRecord& cut : model.cuts) {
    area += cut.area;
    cuts += fmt::format("cut {}: {} blocks, {} islands, {} loops, {} contracted, {} "
                        "short, {} merged, {} small, {} T, {} T kept, {} X\n",
                        cut.number, cut.blocks, cut.counts.islands,
                        cut.counts.pinched_loops, cut.counts.contractions,
                        cut.counts.kept_short, cut.counts.merges, cut.counts.kept_small,
                        cut.counts.t_vertices, cut.counts.kept_t_vertices,
                        cut.counts.x_vertices);
    for (const JointLengthRecord& joint : model.joint_lengths)
      if (joint.cut == cut.number)
        cuts += fmt::format("joint {}: length {:.12g}, pruned {:.12g}\n", joint.joint,
                            joint.drawn, joint.pruned);
  }
  return fmt::format("{} blocks, {} corners, area {:.12g}\n", model.blocks.size(),
                     model.blocks.corners(), area) +
         cuts;
}

/// Judges blocks without predicates of the program. No two of those that a CUT card
/// made overlap, and their areas add up to that of the outline, up to slits by
/// rounding.
void expect_tiling(const Model& model, const CutRecord& cut) {
  std::vector<Polygon> blocks;
  std::vector<std::array<Vec2, 2>> boxes;
  double area = 0.0;
  for (int b = cut.first_block; b < cut.first_block + cut.blocks; ++b) {
    const Polygon& corners = blocks.emplace_back(model.blocks.outline(b));
    boxes.push_back({corners[0], corners[0]});
    for (const Vec2& corner : corners)
      boxes.back() = {boxes.back()[0].cwiseMin(corner),
                      boxes.back()[1].cwiseMax(corner)};
    area += model.blocks.area[b];
  }
  EXPECT_NEAR(area, cut.area, 1e-9 * cut.area);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (std::size_t j = i + 1; j < blocks.size(); ++j) {
      if ((boxes[i][0].array() < boxes[j][1].array()).all() &&
          (boxes[j][0].array() < boxes[i][1].array()).all()) {
        EXPECT_EQ(geometry::testing::common_area(blocks[i], blocks[j]), 0)
            << "blocks " << i + 1 << " and " << j + 1 << " of the cut";
      }
    }
}

class Network : public ::testing::TestWithParam<fs::path> {
 protected:
  // Messages have the name of the deck as it was given.
  void SetUp() override { fs::current_path(GetParam().parent_path()); }
  void TearDown() override { fs::current_path(fs::temp_directory_path()); }
};

TEST_P(Network, HasTheExpectedOutcome) {
  run::RunOptions options;
  options.deck = GetParam().filename().string();
  options.quiet = true;
  ::testing::internal::CaptureStderr();
  const run::CheckedDeck checked = run::build_checked(options);
  std::string outcome = ::testing::internal::GetCapturedStderr();
  if (checked.code == run::done) {
    outcome += outcome_of(checked.model);
    for (const CutRecord& cut : checked.model.cuts)
      expect_tiling(checked.model, cut);
  }
  fs::path expected = GetParam();
  EXPECT_EQ(outcome, slurp(expected.replace_extension(".expected")));
  EXPECT_TRUE(slurp(GetParam()).starts_with("$ ")) << "it says what makes it awkward";
}

INSTANTIATE_TEST_SUITE_P(Corpus, Network, ::testing::ValuesIn(decks_below(corpus)),
                         [](const auto& one) {
                           std::string name = one.param.stem().string();
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Networks, AreFound) { EXPECT_GE(decks_below(corpus).size(), 80U); }

}  // namespace
}  // namespace blocks::testing
