// Which edge acts, how long a decision stands, and what a corner takes along when it
// passes from one edge to another: rules 7, 9-12, docs/departures.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "dynamics/contact_certainty.hpp"
#include "dynamics/contact_decision.hpp"
#include "dynamics/contact_search.hpp"
#include "dynamics/third_travel.hpp"
#include "sanitized.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::random_frames;
using scenes::Scene;

/// A polygon inscribed in a circle, clockwise; sometimes slender, sometimes a star.
geometry::Polygon random_polygon(std::mt19937_64& random, const Vec2& centre,
                                 double radius) {
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const int n = std::uniform_int_distribution<int>(3, 7)(random);
  const double squeeze = uniform(0, 1) < 0.3 ? 0.15 : 1.0, turn = uniform(0, 6.283);
  const bool star = n > 4 && uniform(0, 1) < 0.5;
  geometry::Polygon corners;
  for (int i = 0; i < n; ++i) {
    const double angle = -6.283185307179586 * (i + uniform(-0.3, 0.3)) / n;
    const double r = star && i % 2 == 1 ? 0.5 * radius : radius;
    const Vec2 p = r * Vec2(std::cos(angle), squeeze * std::sin(angle));
    corners.push_back(centre + Frame{turn, Vec2::Zero()}.turn(p));
  }
  return corners;
}

/// Polygons dropped on a floor between walls.
Scene pile(std::uint64_t seed, bool rigid) {
  std::mt19937_64 random(seed);
  Scene scene(random_frames()[seed % 40]);
  Settings& s = scene.model.settings;
  s.rigid = rigid;
  s.friction = 0.4, s.damping = 0.2;
  scene.box(-4, -1, 8, 1, true);
  scene.box(-4, 0, 0.5, 5, true);
  scene.box(3.5, 0, 0.5, 5, true);
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 5; ++i)
      scene.add(random_polygon(random, {-2.6 + 1.3 * i, 0.8 + 1.3 * row}, 0.6));
  scene.gravity(1, -10);
  return scene;
}

// Decisions are kept while the motion leaves them certain: the same bits as if each
// were made in every step.
TEST(KeptDecisions, ChangeNoBit) {
#ifdef BLOCKS_SANITIZED
  const std::uint64_t piles = 1;  // a minute each there
#else
  const std::uint64_t piles = 6;
#endif
  for (const bool rigid : {true, false})
    for (std::uint64_t seed = 0; seed < piles; ++seed) {
      Scene kept = pile(seed, rigid), anew = pile(seed, rigid);
      kept.prepare(), anew.prepare();
      while (kept.model.time < 1.2) {
        kept.step();
        anew.forget_decisions();
        anew.step();
      }
      ASSERT_EQ(kept.model.blocks.corner, anew.model.blocks.corner)
          << seed << (rigid ? " rigid" : " deformable");
      ASSERT_EQ(kept.model.blocks.velocity, anew.model.blocks.velocity) << seed;
      EXPECT_GT(totals(kept.model).active_contacts, 10);
    }
}

/// A small motion of a block: shift, turn, strain.
struct Nudge {
  Vec2 shift;
  double turn, strain;

  /// Moves block b by this much times `size`; how far its arms have changed.
  double move(Blocks& blocks, int b, double size) const {
    const int first = blocks.first_corner[b], count = blocks.corners_of(b);
    auto arms = blocks.arm.middleCols(first, count);
    const Eigen::Matrix2Xd before = arms;
    const Eigen::Matrix2d change =
        size * (Eigen::Matrix2d() << strain, -turn, turn, -strain).finished();
    arms += change * before;
    blocks.centroid.col(b) += size * shift;
    blocks.corner.middleCols(first, count) = arms.colwise() + blocks.centroid.col(b);
    return (arms - before).colwise().norm().maxCoeff();
  }
};

/// Any mixture, often of one kind alone.
Nudge random_nudge(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto perhaps = [&](double x) { return uniform(random) > 0 ? x : 0.0; };
  const double angle = 3.15 * uniform(random), size = perhaps(1.0);
  return {size * Vec2(std::cos(angle), std::sin(angle)), perhaps(uniform(random)),
          perhaps(0.3 * uniform(random))};
}

/// The record if its corner is inside its edge, else none.
int if_inside(const Blocks& blocks, const Contacts& contacts, int i) {
  if (i < 0)
    return -1;
  const int e = contacts.edge[i];
  const auto at = [&](int c) { return Vec2(blocks.corner.col(c)); };
  return geometry::overlap_sign(at(contacts.corner[i]), at(e), at(blocks.next[e])) > 0
             ? i
             : -1;
}

// The bounds themselves: any motion smaller than that of a certainty leaves the acting
// edge as it was, if its condition holds, and one smaller than that of the condition
// leaves the condition as it was.
TEST(CertainTravel, IsSound) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int judged = 0, acting = 0, needles = 0, conditional = 0, conditions_kept = 0;
  std::array<int, 2> watched = {};  ///< edges that corners have passed, and not
  int apart = 0, outside = 0;       ///< sides that are kept from crossing; of two edges
  constexpr int several = dynamics::PlaceInBlock<dynamics::ExactRules>::several;
  for (int trial = 0; trial < 8000; ++trial) {
    Scene scene;
    scene.add(random_polygon(random, {0, 0}, 1.0));
    // mostly touching or overlapping by little
    const double distance = 1.5 + 0.5 * uniform(random);
    if (trial % 8 == 1) {  // a needle in its surface: far edges may face a corner
      const double angle = 3.15 * uniform(random),
                   width = 0.03 + 0.02 * uniform(random);
      const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
      const Vec2 middle(0.8 + 0.3 * uniform(random), 0.3 * uniform(random));
      const auto at = [&](double a, double w) {
        return Vec2(middle + 0.5 * a * along + w * width * across);
      };
      scene.add({at(-1, 0), at(-1, 1), at(1, 1), at(1, 0)});
    } else if (trial % 4 > 0)
      scene.add(random_polygon(random, {distance, 0.3 * uniform(random)}, 1.0));
    else  // two stones on each other, their sides slanted: these may cross
      for (const double top : {0.0, 2.0 + 0.02 * uniform(random)}) {
        const auto x = [&](double at) { return at + 0.05 * uniform(random); };
        scene.add({{x(3), top - 2}, {x(3), top}, {x(5), top}, {x(5), top - 2}});
      }
    dynamics::SearchBuffers buffers;
    dynamics::update_contacts(scene.model, buffers);
    const Contacts& contacts = scene.model.contacts;
    dynamics::group_contacts(scene.model.blocks, contacts, true, buffers.groups);
    for (dynamics::ContactGroup group : buffers.groups.all) {
      const int block = dynamics::edge_block(scene.model.blocks, contacts, group);
      // without a condition, and for longer with one
      const double enough = trial % 2 ? 0.0 : 0.05;
      const dynamics::Certainty known = dynamics::certainty(
          scene.model.blocks, contacts, buffers.groups, group, block, enough);
      if (known.travel <= 0.0 || group.of_notch)
        continue;
      const auto [candidate, travel, place, asks, away] = known;
      group.set(known);
      const auto holds = [&](const Blocks& blocks) {
        return !group.conditional() || dynamics::ContactDecision<dynamics::ExactRules>(
                                           blocks, contacts, buffers.groups)
                                           .stands(group, block);
      };
      const double far = trial % 3 ? 1.0 : 0.0;  // for longer where an edge is watched
      const auto [same, watch, rest] =
          group.conditional() ? dynamics::condition_travel(scene.model.blocks, contacts,
                                                           group, block, far)
                              : dynamics::ConditionTravel{};
      group.set(watch);
      const bool exactly = place != several && watch.apart == std::array{0U, 0U};
      const auto stays = [&](const Blocks& blocks) {
        return dynamics::ContactDecision<dynamics::ExactRules>(blocks, contacts,
                                                               buffers.groups)
            .stays(group, block);
      };
      if (same > 0.0) {
        ASSERT_TRUE(holds(scene.model.blocks)) << trial;
      } else if (!holds(scene.model.blocks)) {
        continue;
      }
      conditional += group.conditional();
      ++judged;
      const int now = dynamics::acting_record(scene.model.blocks, contacts,
                                              buffers.groups, group, block);
      ASSERT_EQ(now, if_inside(scene.model.blocks, contacts, candidate)) << trial;
      acting += now >= 0;
      needles += now >= 0 && trial % 8 == 1;
      for (int k = 0; k < 16; ++k) {
        const Nudge one = random_nudge(random), other = random_nudge(random);
        const int a = scene.model.blocks.corner_block[contacts.corner[group.first]];
        const int b = block;
        const auto nudged = [&](double size, double& u) {
          Blocks blocks = scene.model.blocks;
          const double arms =
              std::max(one.move(blocks, a, size), other.move(blocks, b, size));
          u = size * (one.shift - other.shift).norm() + 2.0 * arms;
          return blocks;
        };
        double u = 0.0;
        nudged(1.0, u);
        if (u == 0.0)
          continue;
        const double unit = u;
        if (same > 0.0) {
          ASSERT_TRUE(holds(nudged(0.99 * same / unit, u))) << trial;
          ++conditions_kept;
        }
        if (rest > same) {
          const Blocks beside = nudged(0.99 * rest / unit, u);
          ASSERT_TRUE(holds(beside) || !stays(beside)) << trial;
          if (exactly) {
            ASSERT_EQ(holds(beside), stays(beside)) << trial;
          }
          ++watched[stays(beside)];
          apart += !exactly && place != several && stays(beside);
          outside += place == several && stays(beside);
        }
        const Blocks moved = nudged(0.99 * travel / unit, u);  // just below the bound
        ASSERT_LT(u, travel);
        if (!holds(moved))
          continue;
        ASSERT_EQ(
            dynamics::acting_record(moved, contacts, buffers.groups, group, block),
            if_inside(moved, contacts, candidate))
            << "trial " << trial << " travel " << travel;
      }
    }
  }
  EXPECT_GT(judged, 10000);
  EXPECT_GT(acting, 500);
  EXPECT_GT(needles, 50);
  EXPECT_GT(conditional, 1000);
  EXPECT_GT(conditions_kept, 10000);
  EXPECT_GT(watched[0], 1000);
  EXPECT_GT(watched[1], 10000);
  EXPECT_GT(apart, 1000);
  EXPECT_GT(outside, 1000);
}

// The same where a third block might hide a side or a corner at its joint: any motion
// of the three that is smaller than the bounds leaves the acting edge as it was.
TEST(CertainTravel, CountsOnThirdBlocks) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int judged = 0, hidden = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const auto about = [&](double at, double by) { return at + by * uniform(random); };
    // a block across the joint of two, its corner in the first, mostly near the joint
    Scene scene(random_frames()[trial % 40]);
    const double end = about(1.0, 0.03), gap = about(0.01, 0.02);
    scene.add({{0, -0.5}, {0, 0}, {end, about(0, 0.01)}, {about(1, 0.03), -0.5}});
    const double level = trial % 2 == 0 ? 0.0 : about(0, 0.05);
    scene.add({{end + gap, -0.5}, {end + gap, level}, {2.0, level}, {2.0, -0.5}});
    const double left = about(0.9, 0.2), deep = about(-0.012, 0.013);
    scene.add({{left, deep},
               {about(left, 0.1), 0.5},
               {left + 1, 0.5},
               {about(left + 1, 0.1), about(deep, 0.01)}});
    dynamics::SearchBuffers buffers;
    dynamics::update_contacts(scene.model, buffers);
    const Contacts& contacts = scene.model.contacts;
    const Blocks& blocks = scene.model.blocks;
    dynamics::group_contacts(blocks, contacts, true, buffers.groups);
    for (dynamics::ContactGroup group : buffers.groups.all) {
      const int own = blocks.corner_block[contacts.corner[group.first]];
      const int block = dynamics::edge_block(blocks, contacts, group);
      const dynamics::Certainty known = dynamics::certainty(
          blocks, contacts, buffers.groups, group, block, trial % 3 ? 0.05 : 0.0005);
      if (known.travel <= 0.0 || known.away.count == 0)
        continue;
      ++judged;
      group.set(known);
      const int third = 3 - own - block;
      double ways = std::numeric_limits<double>::max();
      for (int k = 0; k < known.away.count; ++k) {
        const auto [c, surface] = known.away.places[k];
        buffers.groups.each_third(blocks, known.away.places[k], [&](int other) {
          ASSERT_EQ(other, third);
          ways = std::min(
              ways, dynamics::away_travel(blocks, other, c, {blocks, c, surface}));
        });
      }
      ASSERT_GT(ways, 0.0);
      for (int k = 0; k < 24; ++k) {
        const std::array nudges = {random_nudge(random), random_nudge(random),
                                   random_nudge(random)};
        const auto nudged = [&](double size, double& pair, double& all) {
          Blocks moved = blocks;
          std::array<double, 3> arms = {}, way = {};
          for (const int b : {own, block, third}) {
            arms[b] = nudges[b].move(moved, b, size);
            way[b] = size * nudges[b].shift.norm() + 2.0 * arms[b];
          }
          pair = size * (nudges[own].shift - nudges[block].shift).norm() +
                 2.0 * std::max(arms[own], arms[block]);
          all = way[0] + way[1] + way[2];
          return moved;
        };
        double pair = 0.0, all = 0.0;
        nudged(1.0, pair, all);
        if (all == 0.0)
          continue;
        const double size =
            std::min(pair > 0.0 ? known.travel / pair : 1e9, ways / all);
        const auto decided = [&](const Blocks& moved) {
          return dynamics::acting_record(moved, contacts, buffers.groups, group, block);
        };
        const auto stands = [&](const Blocks& moved) {
          return !group.conditional() ||
                 dynamics::ContactDecision<dynamics::ExactRules>(moved, contacts,
                                                                 buffers.groups)
                     .stands(group, block);
        };
        const Blocks moved = nudged(0.99 * size, pair, all);
        ASSERT_LT(all, ways);
        if (stands(moved)) {
          ASSERT_EQ(decided(moved), if_inside(moved, contacts, known.candidate))
              << "trial " << trial << " travel " << known.travel << " ways " << ways;
        }
        // the third block alone, farther than that
        Blocks beyond = blocks;
        nudges[third].move(beyond, third,
                           8.0 * ways / std::max(nudges[third].shift.norm(), 0.1));
        hidden += decided(beyond) != if_inside(beyond, contacts, known.candidate);
      }
    }
  }
  EXPECT_GT(judged, 5000);
  EXPECT_GT(hidden, 100);
}

// Where no third block is listed a certainty counts on that: it ends with the list, for
// in the next there may be one.
TEST(CertainTravel, EndsWithTheListWhereItCountsOnThirdBlocks) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr unsigned mark = 5;  // nobody looks at it while the group is certain
  int judged = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Scene scene;
    scene.add({{0, -0.5}, {0, 0}, {1, 0.01 * uniform(random)}, {1, -0.5}}, true);
    const double left = 0.9 + 0.09 * uniform(random);
    const double deep = -0.012 + 0.01 * uniform(random);
    scene.add({{left, deep}, {left, 0.5}, {left + 1, 0.5}, {left + 1, deep}});
    scene.prepare();
    Model& model = scene.model;
    dynamics::SearchBuffers buffers;
    dynamics::ContactGroups& groups = buffers.groups;
    dynamics::step(model, buffers);
    std::vector<int> counting;
    for (int g = 0; g < static_cast<int>(groups.all.size()); ++g) {
      dynamics::ContactGroup& group = groups.all[g];
      const int block = dynamics::edge_block(model.blocks, model.contacts, group);
      const dynamics::Certainty known =
          dynamics::certainty(model.blocks, model.contacts, groups, group, block, 0.05);
      if (known.away.count == 0 || known.place != dynamics::Certainty::anywhere)
        continue;
      group.set(known);
      group.hopeless = mark;
      ASSERT_TRUE(groups.watch_thirds(model.blocks, 0, g, known.away));
      counting.push_back(g);
    }
    model.search.left = -1.0;  // a list is due after the step
    dynamics::step(model, buffers);
    std::erase_if(counting, [&](int g) { return groups.all[g].hopeless != mark; });
    const std::size_t count = groups.all.size();
    dynamics::step(model, buffers);
    ASSERT_EQ(groups.all.size(), count);
    for (const int g : counting) {
      ++judged;
      EXPECT_NE(groups.all[g].hopeless, mark) << trial;
    }
  }
  EXPECT_GT(judged, 100);
}

// Neighbours along a slanted joint, the right one a little lower and pressed in: its
// upper corner lies beside the strip of the joint's edge, and so does the other's lower
// corner. With "between" asked of the edge neither acts, and the blocks pass through
// each other.
TEST(SlantedJoint, HoldsALowerNeighbour) {
  for (const Frame& frame : random_frames()) {
    Scene scene(frame);
    const double in = 0.02, down = 1e-4;
    scene.add({{0, 0}, {0, 2}, {3.0, 2}, {3.13, 0}});
    scene.add({{3.13 - in, -down}, {3.0 - in, 2 - down}, {6, 2 - down}, {6, -down}});
    dynamics::SearchBuffers buffers;
    dynamics::update_contacts(scene.model, buffers);
    const Blocks& blocks = scene.model.blocks;
    dynamics::group_contacts(blocks, scene.model.contacts, true, buffers.groups);
    std::vector<std::pair<int, int>> acting;  // corner, edge
    for (const dynamics::ContactGroup& group : buffers.groups.all) {
      const int i = dynamics::acting_record(
          blocks, scene.model.contacts, buffers.groups, group,
          dynamics::edge_block(blocks, scene.model.contacts, group));
      if (i >= 0)
        acting.emplace_back(scene.model.contacts.corner[i],
                            scene.model.contacts.edge[i]);
    }
    // bottom right of the left block on the left side of the other, and vice versa
    EXPECT_EQ(acting, (std::vector<std::pair<int, int>>{{3, 4}, {5, 2}}))
        << frame.angle;
  }
}

/// A box that slides on a floor of boxes at rest on its springs.
struct SlidingBox {
  explicit SlidingBox(const Frame& frame, double friction, double damping)
      : scene(frame) {
    scene.model.settings.friction = friction;
    scene.model.settings.damping = 0.9;
    for (int i = -30; i < 30; ++i)
      scene.box(i, -1, 1, 1, true);
    box = scene.box(0.13, 0, 2.3, 1);
    scene.gravity(0, -10);
    scene.run(1.0);
    scene.model.settings.damping = damping;
    rest = scene.centroid(box).y();
  }
  Scene scene;
  int box = 0;
  double rest = 0.0;  ///< height at rest
};

// The oldest complaint about polygon contact: a box catches at the joints of its floor,
// though there is nothing to catch at. It must brake by mu g, not turn, and sink to the
// overlap W / 2 Kn of its own two corners and no further.
TEST(FloorOfBoxes, LetsABoxSlide) {
  for (const Frame& frame : random_frames(8))
    for (const double speed : {5.0, -5.0}) {
      SlidingBox s(frame, 0.1, 0.3);
      s.scene.velocity(s.box, speed, 0);
      const double began = s.scene.model.time;
      s.scene.run(2.0);
      const double time = s.scene.model.time - began;
      EXPECT_GT(std::abs(s.scene.centroid(s.box).x() - 1.28), 7.5);
      EXPECT_NEAR(std::abs(s.scene.velocity(s.box).x()), 5.0 - 0.1 * 10 * time, 2e-3);
      EXPECT_NEAR(s.scene.model.blocks.spin[s.box], 0.0, 1e-6);
      const double overlap =
          s.scene.weight(s.box) / (2 * s.scene.model.settings.normal_stiffness);
      EXPECT_NEAR(s.scene.centroid(s.box).y(), 0.5 - overlap, 1e-3 * overlap)
          << frame.angle;
    }
}

// Whoever slides, and whether the boxes of the floor are fixed or stand free on a base:
// free blocks beside each other are no joint of the slider's, and sides that lean over
// a joint are shielded as upright ones are.
TEST(FloorOfBoxes, LetsAnyShapeSlideOverFreeBoxes) {
  const std::vector<geometry::Polygon> shapes = {{{0, 0}, {0, 1}, {1, 1}, {1, 0}},
                                                 {{0.2, 0}, {0, 1}, {1, 1}, {0.8, 0}},
                                                 {{0, 0}, {0.2, 1}, {0.8, 1}, {1, 0}}};
  for (const geometry::Polygon& shape : shapes)
    for (const bool fixed : {true, false})
      for (const Frame& frame : random_frames(2)) {
        Scene scene(frame);
        Settings& s = scene.model.settings;
        s.friction = 0.4, s.damping = 0.2;
        s.normal_stiffness = s.shear_stiffness = 1e8;
        scene.box(-1, -2, 14, 1, true);
        scene.box(-1, -1, 1, 1, true), scene.box(12, -1, 1, 1, true);
        for (int i = 0; i < 12; ++i)
          scene.box(i, -1, 1, 1, fixed);
        geometry::Polygon outline;
        for (const Vec2& p : shape)
          outline.push_back(p + Vec2(0.4, 0));
        const int slider = scene.add(outline);
        scene.gravity(0, -10);
        scene.velocity(slider, 10, 0);
        scene.run(1.0);
        EXPECT_GT(scene.centroid(slider).x(), 8.5);
        if (!fixed && shape[0].x() > 0)
          continue;  // tilts, and hits the edges of boxes that spring up before it
        // free boxes are dragged along by their springs
        EXPECT_NEAR(scene.velocity(slider).x(), 10.0 - 4.0 * scene.model.time,
                    fixed ? 1e-3 : 5e-3);
      }
}

// The same over some 970 joints, turned and a million units away: position, speed and
// overlap are those of a box on one smooth floor.
TEST(FloorOfBoxes, LetsABoxSlideOverAThousandJoints) {
  const Frame frame{0.7, Vec2(1e6, -1e6)};
  Scene scene(frame);
  Settings& s = scene.model.settings;
  s.lower = frame.offset - Vec2(2000, 2000), s.upper = frame.offset + Vec2(2000, 2000);
  s.friction = 0.1, s.damping = 0.9, s.fraction = 0.016;
  for (int i = 0; i < 1010; ++i)
    scene.box(i, -1, 1, 1, true);
  const int box = scene.box(1.13, 0, 2.3, 1);
  scene.gravity(0, -10);
  scene.run(1.0);
  s.damping = 0.3;
  scene.velocity(box, 44, 0);
  const double began = scene.model.time;
  scene.run(43.0);
  const double t = scene.model.time - began;
  EXPECT_NEAR(scene.velocity(box).x(), 44 - t, 1e-3);
  EXPECT_NEAR(scene.centroid(box).x(), 2.28 + 44 * t - 0.5 * t * t, 0.05);
  EXPECT_NEAR(scene.model.blocks.spin[box], 0.0, 1e-9);
  const double overlap = scene.weight(box) / (2 * s.normal_stiffness);
  EXPECT_NEAR(scene.centroid(box).y(), 0.5 - overlap, 0.01 * overlap);
}

// What one spring loses the next takes: without friction and damping energy stays.
TEST(FloorOfBoxes, GivesNoEnergy) {
  for (const double speed : {5.0, -5.0}) {
    SlidingBox s({}, 0.0, 0.0);
    s.scene.velocity(s.box, speed, 0);
    const double mass = s.scene.model.blocks.mass[s.box];
    const double before = 0.5 * mass * speed * speed;
    s.scene.run(2.0);
    const auto end = totals(s.scene.model);
    const double lifted = mass * 10 * (s.scene.centroid(s.box).y() - s.rest);
    EXPECT_LT(end.kinetic_energy + lifted, before * (1 + 1e-4));
  }
}

}  // namespace
}  // namespace blocks
