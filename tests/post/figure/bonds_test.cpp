// Figures and pages of bonds: the parts of faces and their colours.
#include "post/figure/sides.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/results/results.hpp"
#include "post/figure/figure.hpp"
#include "post/page/view_data.hpp"
#include "post/read/joint_faces.hpp"
#include "post/read/results_reader.hpp"
#include "scenes/joint_wall.hpp"
#include "tools/program.hpp"

namespace blocks::post {

using namespace draw;

namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Writes a wall of two courses; with a crack in the second frame.
std::string wall_results(const testing::TemporaryFolder& folder, bool with_laws) {
  const std::string path = (folder / "wall.vtkhdf").string();
  Model model = scenes::joint_wall(2, 3);
  if (!with_laws)
    model.law_states.clear(), model.settings.joint_laws.clear();
  output::ResultsWriter writer(path, {"wall.deck", "START\n", "Wall", "1.0.0", 1982});
  for (int i = 0; i < 2; ++i) {
    model.steps = i, model.time = i;
    writer.write(model);
    if (with_laws)
      scenes::crack(model, 1.5);
  }
  return path;
}

/// Aligned faces have four contacts, which cover them twice; offset faces have two.
TEST(FaceParts, CoverTheFacesOfAWall) {
  const testing::TemporaryFolder folder;
  const ResultsReader results(wall_results(folder, true));
  const auto parts = face_parts(results.frame(0), results.contacts(0));
  double across = 0.0, up = 0.0;
  for (const FacePart& part : parts) {
    const Eigen::Vector2d along = part.to - part.from;
    across += std::abs(along.x()), up += std::abs(along.y());
    EXPECT_EQ(part.bond, Bond::bonded);
  }
  // Two vertical faces of 1 in each course; below the courses 6 and 5.5.
  EXPECT_NEAR(up, 2 * 4.0, 1e-12);
  EXPECT_NEAR(across, 6.0 + 5.5, 1e-12);
}

TEST(FaceParts, OfFailedContactsAreDrawnLastAndByTheirSlip) {
  const testing::TemporaryFolder folder;
  const ResultsReader results(wall_results(folder, true));
  const auto parts = face_parts(results.frame(1), results.contacts(1));
  EXPECT_EQ(parts.front().bond, Bond::bonded);
  EXPECT_EQ(parts.back().bond, Bond::failed);
  for (std::size_t i = 1; i < parts.size(); ++i)
    EXPECT_LE(parts[i - 1].slip, parts[i].slip);
}

TEST(BondFigure, HasFacesAndALegend) {
  const testing::TemporaryFolder folder;
  const ResultsReader results(wall_results(folder, true));
  FigureOptions options;
  options.colour = "bond";
  const std::string intact = figure_svg(results, {0}, options),
                    cracked = figure_svg(results, {1}, options);
  const auto rgb = [](const Colour& c) {
    return fmt::format("{:.6g}%", 100 * c.r);  // cairo writes percentages
  };
  EXPECT_THAT(intact, HasSubstr("bonded"));
  EXPECT_THAT(intact, Not(HasSubstr("failed")));
  EXPECT_THAT(intact, HasSubstr(rgb(bonded_colour)));
  EXPECT_THAT(cracked, HasSubstr("failed"));
  EXPECT_THAT(cracked, HasSubstr("slip"));
  EXPECT_THAT(cracked, HasSubstr(rgb(slip_colour(1.0))));
}

TEST(BondFigure, IsRefusedWithoutLaws) {
  const testing::TemporaryFolder folder;
  const ResultsReader results(wall_results(folder, false));
  FigureOptions options;
  options.colour = "bond";
  try {
    figure_svg(results, {0}, options);
    ADD_FAILURE() << "it was drawn";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no contact has the law of a joint"));
    EXPECT_THAT(error.what(), HasSubstr("\n  hint: "));
  }
}

TEST(BondPage, HasTheContactsOnlyIfTheyHaveLaws) {
  const testing::TemporaryFolder folder;
  {
    const ResultsReader results(wall_results(folder, false));
    const std::string meta = view_data(results, 1, std::nullopt).meta;
    EXPECT_THAT(meta, Not(HasSubstr("bond")));
    EXPECT_THAT(meta, Not(HasSubstr("slip")));
  }
  const ResultsReader results(wall_results(folder, true));
  const std::string meta = view_data(results, 1, std::nullopt).meta;
  for (const char* name : {"bond_counts", "bond_edge", "slip_colours", "largest_slip"})
    EXPECT_THAT(meta, HasSubstr(name));
}

}  // namespace
}  // namespace blocks::post
