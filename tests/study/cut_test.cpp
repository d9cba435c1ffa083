// The scene `cut`: random domains, their pieces, and the motion on both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "geometry/polygon.hpp"
#include "study/beside_uncut.hpp"
#include "study/block_run.hpp"
#include "study/cut_domain.hpp"
#include "study/free_shift.hpp"
#include "study/scenes.hpp"
#include "study/study.hpp"

namespace blocks::study {
namespace {

constexpr std::uint64_t seed = 1982;

double area_of(const Polygon& outline) {
  return geometry::section_properties(outline).area;
}

/// The largest number of pieces that have a corner at the same place.
int max_at_a_point(const CutDomain& domain) {
  std::map<std::pair<long, long>, std::set<std::size_t>> pieces_at;
  for (std::size_t i = 0; i < domain.pieces.size(); ++i)
    for (const Vec2& p : domain.pieces[i])
      pieces_at[{std::lround(1e8 * p.x()), std::lround(1e8 * p.y())}].insert(i);
  std::size_t max = 0;
  for (const auto& [place, pieces] : pieces_at)
    max = std::max(max, pieces.size());
  return static_cast<int>(max);
}

// Flush pieces fill the domain, so their areas add up to its area.
TEST(CutDomains, AreFilledBySimplePiecesOfALeastWidth) {
  int with_three = 0, with_four = 0, several = 0;
  for (int number = 0; number < 400; ++number) {
    Draws draw(seed, number, 1);
    const auto& kinds = domain_kinds();
    const std::string& kind = kinds[static_cast<std::size_t>(number) % kinds.size()];
    SCOPED_TRACE(kind + ' ' + std::to_string(number));
    CutDomain domain = draw_domain(draw, kind);
    cut_domain(draw, number / 8 % 6, domain);
    EXPECT_LE(domain.joints, number / 8 % 6);
    EXPECT_GE(domain.pieces.size(), static_cast<std::size_t>(domain.joints) + 1);
    double area = 0.0;
    for (const Polygon& piece : domain.pieces) {
      const geometry::OutlineCheck found = geometry::check_outline(piece);
      ASSERT_EQ(found.fault, geometry::OutlineFault::none) << describe(found);
      EXPECT_FALSE(found.anticlockwise);
      EXPECT_GE(narrowest_width(piece), min_width);
      EXPECT_GE(sharpest_angle(piece), min_angle);
      area += area_of(piece);
    }
    EXPECT_NEAR(area, area_of(domain.outline), 1e-12 * area);
    several += domain.joints > 1;
    with_three += max_at_a_point(domain) >= 3;
    with_four += max_at_a_point(domain) >= 4;
    const Polygon marked = marked_outline(domain);
    EXPECT_GE(marked.size(), domain.outline.size());
    EXPECT_NEAR(area_of(marked), area, 1e-12 * area);
  }
  EXPECT_GT(several, 200);
  EXPECT_GT(with_three, 30);
  EXPECT_GT(with_four, 10);
}

TEST(CutDomains, HaveTheSharpestCornerOfTheirNotch) {
  for (int number = 0; number < 50; ++number) {
    Draws draw(seed, number, 1);
    const double half = draw_domain(draw, "notch").sharpest * 180.0 / M_PI;
    EXPECT_GT(half, 15.0 - 1e-9);
    EXPECT_LT(half, 80.0 + 1e-9);
    EXPECT_DOUBLE_EQ(draw_domain(draw, "ridge").sharpest, 0.5 * M_PI);
    EXPECT_DOUBLE_EQ(draw_domain(draw, "flat").sharpest, 0.5 * M_PI);
  }
}

// A box is in a floor by 0.1. The tip of a wedge is below the bottom of a notch of 45
// degrees by 0.2, and a shift upwards frees it.
TEST(FreeShift, IsBetweenItsBoundsAndExactForABoxAndAWedge) {
  const Domain floor = make_domain({{-3, 0}, {3, 0}, {3, -2}, {-3, -2}});
  const Polygon box = {{0, -0.1}, {0, 0.9}, {1, 0.9}, {1, -0.1}};
  EXPECT_NEAR(min_shift(box, floor), 0.1, 1e-15);
  EXPECT_NEAR(max_shift(box, floor), 0.1, 1e-15);
  EXPECT_NEAR(free_shift(box, floor, {0, 1}), 0.1, 1e-15);
  EXPECT_NEAR(free_shift(box, floor, {0, -1}), 2.9, 1e-15);
  const Domain notch = make_domain({{-2, 2}, {0, 0}, {2, 2}, {2, -2}, {-2, -2}});
  const Polygon wedge = {{0, -0.2}, {-0.4, 1}, {0.4, 1}};
  EXPECT_NEAR(min_shift(wedge, notch), 0.2, 1e-15);
  EXPECT_NEAR(max_shift(wedge, notch), 0.2, 1e-15);
  const Polygon above = {{0, 0.3}, {-0.4, 1.5}, {0.4, 1.5}};
  EXPECT_EQ(min_shift(above, notch), 0.0);
  EXPECT_EQ(max_shift(above, notch), 0.0);
}

/// Runs the scene with so many joints and returns what was measured.
Outcome measure_cut(int number, int joints) {
  Draws draw(seed, number, 1);
  const Scene scene = scenes::cut_by(draw, joints);
  Frame frame = random_frame({seed, 1e3, {}}, number, scene.size);
  Trace trace;
  return measure_beside_uncut(scene, frame, all_variants().front(), scene.steps, trace);
}

// Both runs are the same if there is no joint.
TEST(CutScene, MovesAsTheUncutDomainWithoutJoints) {
  for (int number = 0; number < 300; ++number) {
    const Outcome outcome = measure_cut(number, 0);
    EXPECT_FALSE(outcome.hung) << number << ": " << outcome.why;
  }
}

/// Runs the first frames of a scene with one variant.
Row run_first(std::string_view scene, std::string_view variant, int frames) {
  StudyChoice choice;
  choice.count = frames;
  choice.variants = {find_variant(variant)};
  return run_study(make_scene(scene), choice).rows[0];
}

// The frames of every build.
TEST(CutScene, IsPassedByTheContactRule) {
  const Row row = run_first("cut", "default", 2000);
  EXPECT_EQ(row.hung, 0);
  EXPECT_EQ(row.fell, 0);
  EXPECT_EQ(row.deep, 0);
  int frames = 0;
  for (const KindCount& kind : row.kinds)
    frames += kind.frames;
  EXPECT_EQ(frames, 2000);
}

// Pieces that are bonded to each other carry the block like fixed ones, but for some
// corners between two of them (docs/robustness.md#cut-domains).
TEST(BondedScene, MovesAsTheUncutDomain) {
  const Row row = run_first("bonded", "default", 200);
  EXPECT_EQ(row.hung, 0);
  EXPECT_EQ(row.fell, 0);
  EXPECT_LE(row.deep, 2);
}

// The bonds hold: without them, the pieces fall apart.
TEST(BondedScene, HasBonds) {
  Draws draw(seed, 0, 1);
  const Scene scene = scenes::bonded(draw);
  const Model model = place(scene.model, Frame{}, Corners::sharp);
  const BlockRun run(model, all_variants().front());
  int bonded = 0;
  for (const LawState& state : run.model.law_states)
    bonded += state.bonded;
  EXPECT_GE(bonded, 2 * (scene.model.blocks.size() - 2));
}

// The rules of the report fail, with a reason for each frame.
TEST(CutScene, FindsTheFailuresOfTheReportsRules) {
  const Row row = run_first("cut", "report", 40);
  EXPECT_GT(row.hung, 0);
  EXPECT_GT(row.fell, 0);
  EXPECT_EQ(row.reasons.size(),
            std::size_t(std::count_if(row.reasons.begin(), row.reasons.end(),
                                      [](const Reason& r) { return !r.why.empty(); })));
}

// Without the part of the rule about joints, blocks hang at joints of a face.
TEST(CutScene, FindsBlocksThatHangAtJoints) {
  StudyChoice choice;
  choice.first = 84, choice.count = 1;
  choice.variants = {find_variant("default"), find_variant("no-joints")};
  const Study study = run_study(make_scene("cut"), choice);
  EXPECT_EQ(study.rows[0].hung + study.rows[0].fell, 0);
  EXPECT_EQ(study.rows[1].hung, 1);
}

}  // namespace
}  // namespace blocks::study
