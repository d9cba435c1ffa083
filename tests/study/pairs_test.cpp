// Contact decisions of block pairs: kept decisions change hardly anything, and blocks
// of every shape carry each other.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include "dynamics/update_pairs.hpp"
#include "geometry/overlap.hpp"
#include "study/frame.hpp"
#include "study/scene_builder.hpp"
#include "study/study.hpp"
#include "study/variants.hpp"

namespace blocks::study {
namespace {

using geometry::Polygon;

/// The contact rule that decides every pair in every step.
const dynamics::PairwiseRule without_kept_decisions{{false}};

/// Steps a model with and without kept decisions. Corners may move apart by
/// `max_apart`, [L]; 0: all bits have to be equal. Returns the number of kept
/// decisions, summed over the steps.
long compare(const Model& start, int steps, double max_apart = 0.0) {
  const std::unique_ptr<VariantRun> run = find_variant("default")->start();
  Model kept = start, decided = start;
  dynamics::Workspace a, b;
  b.rule = &without_kept_decisions;
  dynamics::prepare(kept), dynamics::prepare(decided);
  long reused = 0;
  for (int k = 0; k < steps; ++k) {
    run->find(kept, a), run->find(decided, b);
    run->step(kept, a), dynamics::step(decided, b);
    for (int p = 0; p < a.index.size(); ++p)
      reused += a.decisions.holds(kept.blocks, a.parts, a.index.pairs[p], p);
    const double apart =
        (kept.blocks.corner - decided.blocks.corner).cwiseAbs().maxCoeff();
    if (apart > max_apart ||
        (max_apart == 0.0 && kept.blocks.velocity != decided.blocks.velocity)) {
      ADD_FAILURE() << "the runs part by " << apart << " in step " << k;
      return reused;
    }
  }
  return reused;
}

/// In these scenes blocks overlap by less than the slack and meet in points, so a
/// decision may be late.
bool may_be_late(std::string_view scene) {
  return scene == "notch" || scene == "bonded";
}

TEST(Pairs, GiveTheSameBitsWithKeptDecisions) {
  long reused = 0;
  for (const std::string_view name : scene_names())
    for (const int number : {4, 7}) {
      SCOPED_TRACE(name);
      Scene varied;
      const Scene scene = make_scene(name);
      const Scene& here = scene_in_frame(scene, 1982, number, varied);
      const Frame frame = random_frame({}, number, here.size);
      reused += compare(place(here.model, frame, Corners::sharp), 300,
                        may_be_late(name) ? 1e-5 * frame.scale * here.size : 0.0);
    }
  EXPECT_GT(reused, 10000) << "hardly any decision is kept";
}

// Far from the origin, rounding moves a stored corner farther than its block moves in a
// step. This is enough to pass the slack of an edge.
TEST(Pairs, GiveTheSameBitsFarFromTheOrigin) {
  const Scene scene = make_scene("wall");
  for (const int number : {1, 2, 9})
    compare(place(scene.model, random_frame({}, number, scene.size), Corners::sharp),
            1500);
}

// A decision must remain valid while the shapes change.
TEST(Pairs, GiveTheSameBitsForDeformableBlocks) {
  long reused = 0;
  for (const char* name :
       {"wall", "soft", "stake", "bricks", "step-slabs", "undercut"}) {
    SCOPED_TRACE(name);
    Scene varied;
    const Scene scene = make_scene(name);
    Model model = scene_in_frame(scene, 1982, 3, varied).model;
    model.settings.rigid = false;
    reused += compare(model, 300, may_be_late(name) ? 1e-5 : 0.0);
  }
  EXPECT_GT(reused, 1000) << "hardly any decision is kept";
}

// Without a part of the rule one scene fails.
TEST(Pairs, NeedEveryPartOfTheRule) {
  struct Known {
    const char *scene, *variant;
    int frames, min;
  };
  for (const Known& known : {Known{"cut", "no-far", 40, 2},
                             {"floor", "no-joints", 4, 4},
                             {"bow", "no-faces", 4, 4}}) {
    StudyChoice choice;
    choice.count = known.frames;
    choice.frames.offset = 1e3;  // Farther away, rounding moves tips out of the slack.
    choice.variants = {find_variant(known.variant), find_variant("default")};
    const Study study = run_study(make_scene(known.scene), choice);
    EXPECT_GE(study.rows[0].hung + study.rows[0].deep, known.min) << known.variant;
    EXPECT_EQ(study.rows[1].hung + study.rows[1].fell + study.rows[1].deep, 0)
        << known.scene;
  }
}

Polygon star(int tips, double inner) {
  Polygon outline;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = -std::numbers::pi * i / tips + 0.5 * std::numbers::pi;
    const double radius = i % 2 == 0 ? 1.0 : inner;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

Polygon comb(int teeth) {
  Polygon outline = {{0, 0}};
  for (int i = 0; i < teeth; ++i) {
    const double x = 0.5 * i;
    outline.insert(outline.end(), {{x, 1}, {x + 0.25, 1}});
    if (i + 1 < teeth)
      outline.insert(outline.end(), {{x + 0.25, 0.3}, {x + 0.5, 0.3}});
  }
  outline.emplace_back(0.5 * (teeth - 1) + 0.25, 0);
  return outline;
}

struct Shape {
  std::string name;
  Polygon outline;
};
const std::vector<Shape> shapes = {
    {"L", {{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}}},
    {"U", {{0, 0}, {0, 2}, {0.5, 2}, {0.5, 0.5}, {1.5, 0.5}, {1.5, 2}, {2, 2}, {2, 0}}},
    {"star", star(5, 0.4)},
    {"comb", comb(4)},
    {"spiral",
     {{0, 0},
      {0, 3},
      {3, 3},
      {3, 1},
      {1, 1},
      {1, 2},
      {2, 2},
      {2, 1.5},
      {1.5, 1.5},
      {1.5, 1.7},
      {1.2, 1.7},
      {1.2, 1.2},
      {2.5, 1.2},
      {2.5, 2.5},
      {0.5, 2.5},
      {0.5, 0.5},
      {3, 0.5},
      {3, 0}}},
    {"needle", {{0, 0}, {0, 0.003}, {3, 0.003}, {3, 0}}}};

/// Returns the largest share of the smaller of two blocks that is in the other one.
double max_shared(const Blocks& blocks) {
  std::vector<Polygon> outlines;
  for (int b = 0; b < blocks.size(); ++b)
    outlines.push_back(blocks.outline(b));
  double max = 0.0;
  for (const auto& pair :
       geometry::overlapping_pairs(outlines, {}, geometry::Figures::quick))
    if (blocks.is_free(pair.first) || blocks.is_free(pair.second))
      max = std::max(
          max, pair.area / std::min(blocks.area[pair.first], blocks.area[pair.second]));
  return max;
}

Polygon moved(Polygon outline, double angle, double x, double y) {
  for (Vec2& p : outline)
    p = Vec2(x + std::cos(angle) * p.x() - std::sin(angle) * p.y(),
             y + std::sin(angle) * p.x() + std::cos(angle) * p.y());
  return outline;
}

double lowest(const Polygon& outline) {
  double y = INFINITY;
  for (const Vec2& p : outline)
    y = std::min(y, p.y());
  return y;
}

// A block of each shape falls on a floor of boxes, and a box and a triangle fall on it.
TEST(Pairs, CarryBlocksOfEveryShape) {
  for (const Shape& shape : shapes)
    for (int turn = 0; turn < 8; ++turn) {
      scenes::SceneBuilder draft("shape", "", 0);
      draft.rub(0.5, 0.5);
      for (int i = -4; i < 4; ++i)
        draft.box(2 * i, -1, 2, 1, true);
      Polygon outline = moved(shape.outline, 0.8 * turn, 0, 0);
      const double up = 0.02 - lowest(outline);
      outline = moved(outline, 0, 0.37, up);
      draft.add(outline, false);
      double top = -INFINITY;
      for (const Vec2& p : outline)
        top = std::max(top, p.y());
      draft.box(0.4, top + 0.05, 0.3, 0.4);
      draft.add({{0.9, top + 0.05}, {0.7, top + 0.5}, {1.2, top + 0.6}}, false);
      draft.gravity(0, -scenes::g);
      Model model = draft.model();
      model.settings.normal_stiffness = model.settings.shear_stiffness = 1e8;
      dynamics::Workspace work;
      const std::unique_ptr<VariantRun> run = find_variant("default")->start();
      dynamics::prepare(model);
      double shared = 0.0;
      for (int k = 0; k < 4000; ++k) {
        run->find(model, work);
        ASSERT_TRUE(run->step(model, work).finite) << shape.name << turn;
        if (k % 500 == 499)
          shared = std::max(shared, max_shared(model.blocks));
      }
      EXPECT_LT(shared, shape.name == "needle" ? 0.2 : 0.02) << shape.name << turn;
      for (int b = 0; b < model.blocks.size(); ++b)
        EXPECT_GT(model.blocks.centroid(1, b), b < 8 ? -1.0 : -0.01)
            << shape.name << turn << " block " << b;
    }
}

}  // namespace
}  // namespace blocks::study
