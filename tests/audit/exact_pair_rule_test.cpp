// Contacts that the judge of the contact rule decides for simple blocks. The judge and
// the program must agree on each of them.
#include "audit/exact_pair_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "audit/rule_cluster.hpp"
#include "audit/story.hpp"
#include "tests/audit/fault_of_parts.hpp"

namespace blocks {
namespace {

using audit::ConvexPart;
using audit::ExactPairRule;
using audit::PairDecision;
using testing::Cluster;
using testing::ContactSet;

geometry::Polygon box(double x, double y, double w, double h) {
  return {{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}};
}

Cluster cluster_of(const std::vector<geometry::Polygon>& outlines) {
  std::vector<NewBlock> made;
  for (const geometry::Polygon& outline : outlines)
    made.push_back({outline, 1, 1.0});
  return {made, {}};
}

/// Returns the contacts of a box with one that is shifted by (x, y). Corners 0 to 3 are
/// those of the lower box, beginning with the lower left one.
ContactSet contacts_with_box_above(double x, double y) {
  return cluster_of({box(0, 0, 2, 1), box(x, y, 2, 1)}).judge().decide(0, 1).contacts;
}

TEST(ExactPairRule, AlignedFacesHaveFourContacts) {
  EXPECT_EQ(contacts_with_box_above(0, 0.875),
            (ContactSet{{1, 7}, {2, 7}, {4, 1}, {7, 1}}));
}

TEST(ExactPairRule, OffsetFacesHaveTwoContacts) {
  EXPECT_EQ(contacts_with_box_above(0.5, 0.875), (ContactSet{{2, 7}, {4, 1}}));
}

TEST(ExactPairRule, TouchingFacesHaveNoContact) {
  EXPECT_EQ(contacts_with_box_above(0.5, 1.0), ContactSet{});
}

/// Requires contacts between two blocks that overlap by `overlap` along a horizontal
/// edge of length 2. All are on the common faces. The upper block is shifted and
/// turned.
void expect_contacts_of_faces(const geometry::Polygon& lower, geometry::Polygon upper,
                              double overlap, double shift, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec2& corner : upper)
    corner = {c * corner.x() - s * corner.y() + shift,
              s * corner.x() + c * corner.y() - overlap};
  const Cluster cluster = cluster_of({lower, upper});
  const ContactSet contacts = cluster.judge().decide(0, 1).contacts;
  EXPECT_EQ(cluster.by_program(0, 1), contacts);
  // The block is turned about its left end, which may be beyond that of the lower one.
  if (overlap > 2 * std::abs(shift * angle)) {
    EXPECT_FALSE(contacts.empty()) << overlap << ' ' << shift << ' ' << angle;
  }
  for (const auto& [corner, edge] : contacts)
    EXPECT_LT(cluster.judge().overlap(corner, edge),
              2 * (overlap + 2 * std::abs(angle)))
        << overlap << ' ' << shift << ' ' << angle;
}

// Blocks of a layer share whole edges. If both have acute angles at the ends of the
// edge, no corner is inside the other block.
TEST(ExactPairRule, SharedEdgesActForAnyAnglesAtTheirEnds) {
  for (const double inset : {0.6, 0.2, 0.0, -0.4})  // The far edges are shorter by it.
    for (const double overlap : {1e-9, 1e-6, 1e-3})
      for (const double shift : {0.0, 1e-9, -1e-7, 3e-6, -1e-4, 1e-3})
        for (const double angle : {0.0, 1e-10, -1e-7, 1e-4})
          expect_contacts_of_faces({{inset, -1}, {0, 0}, {2, 0}, {2 - inset, -1}},
                                   {{0, 0}, {inset, 1}, {2 - inset, 1}, {2, 0}},
                                   overlap, shift, angle);
}

// Nothing is rounded, so the smallest double makes the difference.
TEST(ExactPairRule, ContactActsForTheSmallestOverlap) {
  const auto contacts = [](double y) {
    return cluster_of({box(0, -1, 4, 1), box(1, y, 1, 1)})
        .judge()
        .decide(0, 1)
        .contacts;
  };
  EXPECT_EQ(contacts(-0x1p-1074), (ContactSet{{4, 1}, {7, 1}}));
  EXPECT_EQ(contacts(0x1p-1074), ContactSet{});
}

// The angles differ from ten degrees by 1e-12.
TEST(ExactPairRule, SidesFaceEachOtherWithinTenDegrees) {
  constexpr double degree = 3.14159265358979323846 / 180;
  for (const double off : {-1e-12, 1e-12}) {
    const double angle = 10 * degree + off;
    const Vec2 p(2, -0.01);
    const ExactPairRule judge =
        cluster_of({box(0, -1, 4, 1),
                    {p, p + Vec2(0, 1), p + Vec2(std::cos(angle), -std::sin(angle))}})
            .judge();
    EXPECT_EQ(judge.face({0, 1, 1, 2}, {1, 2, 6, 4}), off < 0);
    EXPECT_FALSE(judge.face({0, 1, 1, 2}, {0, 1, 1, 2}));
  }
}

/// Returns the contacts between two blocks. Expects the program to find the same ones.
ContactSet contacts(const Cluster& cluster, int a, int b) {
  const ContactSet found = cluster.judge().decide(a, b).contacts;
  EXPECT_EQ(cluster.by_program(a, b), found);
  return found;
}

/// Returns the story of two blocks as one text.
std::string story_of(const Cluster& cluster, int a, int b) {
  const ExactPairRule judge = cluster.judge();
  std::string text = "\n";
  for (const std::string& line : audit::story(judge, a, b, judge.decide(a, b))) {
    EXPECT_LE(line.size(), 98U);
    text += line + "\n";
  }
  return text;
}

constexpr double h = 0x1p-6;  ///< how deep blocks are sunk in

/// A slider on two boxes of a floor, whose corners are 0 to 3 and 4 to 7. It is sunk in
/// by h and has just entered the second box, whose top is at y = top.
Cluster slider(double top) {
  return cluster_of(
      {box(-4, -1, 4, 1), box(0, -1, 4, 1 + top), box(-1, -h, 1 + 0x1p-8, 1)});
}

TEST(ExactPairRule, ASideInAFlushFloorIsHidden) {
  const Cluster cluster = slider(0.0);
  EXPECT_EQ(contacts(cluster, 0, 2), (ContactSet{{2, 11}, {8, 1}}));
  EXPECT_EQ(contacts(cluster, 1, 2), (ContactSet{{5, 11}, {11, 5}}));
  EXPECT_EQ(contacts(slider(0.5 * h), 1, 2), (ContactSet{{5, 11}, {11, 5}}));
  EXPECT_EQ(story_of(cluster, 1, 2), R"(
blocks 2 and 3: corner 2 of block 2 on edge 4 of block 3; corner 4 of block 3 on edge 2 of block 2
axis of edge 1 of block 2: corner 4 of block 3 is 0.00390625 deep, facing edge 3 of block 3
  hidden by block 1, a third part of block 2: shifted out, block 3 overlaps it by 0.015625; a
    slide of 0.015625 ends that, with 0 of the side left, or one of 1.98438, with 0
axis of edge 3 of block 3: corner 1 of block 2 is 0.00390625 deep, facing edge 1 of block 2
  hidden by block 1, a third part of block 2: shifted out, block 3 overlaps it by 0.015625; a
    slide of 0.015625 ends that, with 0 of the side left, or one of 1.98438, with 0
axis of edge 2 of block 2: corner 1 of block 3 is 0.015625 deep, facing edge 4 of block 3
  acts
5 deeper axes are not needed
corner 4 of block 3 on edge 2 of block 2: 0.015625 deep: acts
corner 1 of block 3 on edge 2 of block 2: 0.015625 deep: foot beyond the end
corner 2 of block 2 on edge 4 of block 3: 0.015625 deep: acts
corner 3 of block 2 on edge 4 of block 3: 0.015625 deep: foot beyond the end
)");
}

TEST(ExactPairRule, AStepHigherThanTheOverlapActs) {
  const Cluster cluster = slider(2.5 * h);
  EXPECT_EQ(contacts(cluster, 1, 2), (ContactSet{{5, 10}, {11, 4}}));
}

TEST(ExactPairRule, AWallOnAFloorActs) {
  EXPECT_EQ(contacts(slider(2.0), 1, 2), (ContactSet{{10, 4}, {11, 4}}));
}

/// A stake with flanks of 45 degrees, its tip at (x, -h) below the joint of two boxes
/// whose tops fall away from the joint with the slope `fall`.
Cluster stake(double x, double fall) {
  return cluster_of({{{-4, -8}, {-4, -4 * fall}, {0, 0}, {0, -8}},
                     {{0, -8}, {0, 0}, {4, -4 * fall}, {4, -8}},
                     {{x, -h}, {x - 1, 1 - h}, {x + 1, 1 - h}}});
}

TEST(ExactPairRule, AStakeOnAClosedJointRestsOnTheTop) {
  const Cluster cluster = stake(0x1p-10, 0.0);
  EXPECT_EQ(contacts(cluster, 0, 2), ContactSet{});
  EXPECT_EQ(contacts(cluster, 1, 2), (ContactSet{{8, 5}}));
  EXPECT_NE(story_of(cluster, 1, 2).find("hidden by block 1, a third part of block 2"),
            std::string::npos);
}

// The top of a ridge is a corner of both boxes, and it acts on the flank of a wedge.
TEST(ExactPairRule, TheTopOfARidgeActsOnAFlank) {
  const Cluster cluster = cluster_of({{{-4, -8}, {-4, -4}, {0, 0}, {0, -8}},
                                      {{0, -8}, {0, 0}, {4, -4}, {4, -8}},
                                      {{-1, -1}, {-1, 2}, {1, 2}, {1, -0.5}}});
  for (const int side : {0, 1})
    EXPECT_FALSE(contacts(cluster, side, 2).empty());
}

// The tip of a wedge has passed the bottom of a notch between two blocks, so its foot
// is beyond the end of each wall.
TEST(ExactPairRule, ATipActsOnBothWallsOfANotch) {
  const Cluster cluster = cluster_of({{{-2, -1}, {-2, 2}, {0, 0}, {0, -1}},
                                      {{0, -1}, {0, 0}, {2, 2}, {2, -1}},
                                      {{0, -0.0625}, {-0.5, 1}, {0.5, 1}}});
  EXPECT_EQ(contacts(cluster, 0, 2), (ContactSet{{8, 1}}));
  EXPECT_EQ(contacts(cluster, 1, 2), (ContactSet{{8, 5}}));
  EXPECT_NE(story_of(cluster, 0, 2).find("acts: foot beyond the end, in a notch"),
            std::string::npos);
}

// At the end of a flush floor there is no notch.
TEST(ExactPairRule, ATipBeyondAFlatEndDoesNotAct) {
  const Cluster cluster = cluster_of({{{-2, -1}, {-2, 0}, {0, 0}, {0, -1}},
                                      {{0, -1}, {0, 0}, {2, 0}, {2, -1}},
                                      {{0.0625, -0.0625}, {-0.5, 1}, {0.5, 1}}});
  EXPECT_EQ(contacts(cluster, 0, 2), ContactSet{});
  EXPECT_EQ(contacts(cluster, 1, 2), (ContactSet{{8, 5}}));
}

// A tip is in the angle between a floor and a wall that abuts it.
TEST(ExactPairRule, ATipAtTheFootOfAWallActsOnTheWall) {
  const Cluster cluster = cluster_of(
      {box(-4, -1, 4, 1), box(0, -1, 1, 4), {{0x1p-8, -h}, {-2, 1}, {-1, 2}}});
  EXPECT_EQ(contacts(cluster, 0, 2), (ContactSet{{8, 1}}));
  EXPECT_EQ(contacts(cluster, 1, 2), (ContactSet{{8, 4}}));
}

// The tip is between two boxes with a gap narrower than its overlap.
TEST(ExactPairRule, ATipAboveANarrowGapActs) {
  const Cluster cluster = cluster_of(
      {box(-4, -1, 4, 1), box(0.5 * h, -1, 4, 1), {{0.25 * h, -h}, {-1, 1}, {1, 1}}});
  const ContactSet all[] = {contacts(cluster, 0, 2), contacts(cluster, 1, 2)};
  EXPECT_EQ(all[0], (ContactSet{{8, 1}}));
  EXPECT_EQ(all[1], (ContactSet{{8, 5}}));
  EXPECT_NE(story_of(cluster, 0, 2).find("acts: foot beyond the end, at the joint"),
            std::string::npos);
}

// Two tips are crossed and sunk into a floor. Each of the three blocks hides the axes
// of the other two, so each pair may be left to the third block; it is left in one
// case.
TEST(ExactPairRule, CarriersLeanOnNobody) {
  const Cluster cluster =
      cluster_of({box(-8, -1, 8.1, 1),
                  {{-3.5502, -0.0519}, {-1.5659, 1.1739}, {-1.5568, 0.4740}},
                  {{-2.9034, 1.3670}, {-3.5229, -0.1615}, {-3.6956, 1.4787}}});
  int left = 0;
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
    left += contacts(cluster, a, b).empty();
  EXPECT_LE(left, 1);
}

// A box is on the top of an L, where an inner side ends in its bottom.
TEST(ExactPairRule, AnInnerSideIsHidden) {
  const Cluster cluster = cluster_of(
      {{{0, 0}, {0, 1}, {4, 1}, {4, -1}, {2, -1}, {2, 0}}, box(1.9, 1 - h, 1, 1)});
  for (const auto& [corner, edge] : contacts(cluster, 0, 1))
    EXPECT_NEAR(cluster.judge().overlap(corner, edge), h, 1e-12);
  EXPECT_EQ(contacts(cluster, 0, 1).size(), 2U);
}

// A tip has passed a side that slants away from it. The far side of the block is no
// side by which it has entered.
TEST(ExactPairRule, AFarSideDoesNotAct) {
  const Cluster cluster = cluster_of({{{2, -2}, {0, 0}, {0.5, 0}, {2.5, -2}},
                                      {{-0.2, 0.5}, {0.2, 0.5}, {0.002, -0.0021}}});
  EXPECT_EQ(contacts(cluster, 0, 1), (ContactSet{{6, 1}}));
}

// The corners of the L are counted from 0 at the lower left.
TEST(ExactPairRule, FaultOfPartsThatDoNotTileTheBlockIsFound) {
  Blocks blocks;
  blocks.append({{{{0, 0}, {0, 3}, {1, 3}, {1, 1}, {3, 1}, {3, 0}}, 1, 1.0},
                 {box(5, 0, 1, 1), 1, 1.0}});
  const auto fault = [&](const std::vector<std::vector<int>>& corners) {
    std::vector<ConvexPart> parts;
    for (const std::vector<int>& part : corners)
      parts.push_back({0, part});
    return audit::fault_of_parts(blocks, 0, parts);
  };
  const std::string gap = "The parts overlap or leave a part of the block out.";
  EXPECT_EQ(fault({{0, 1, 2, 3}, {0, 3, 4, 5}}), "");
  EXPECT_EQ(fault({{0, 1, 2, 3}}), gap);
  EXPECT_EQ(fault({{0, 1, 2, 3}, {0, 3, 4, 5}, {3, 4, 5}}), gap);
  EXPECT_EQ(fault({{0, 1, 2, 3}, {0, 2, 4, 5}}), gap);
  EXPECT_EQ(fault({{0, 1, 2, 3, 4, 5}}), "A part is not convex.");
  EXPECT_EQ(fault({{5, 4, 3, 0}, {0, 1, 2, 3}}), "A part is not convex.");
  EXPECT_EQ(fault({{0, 1, 2, 3}, {0, 3, 4, 7}}),
            "A part has a corner of another block.");
}

}  // namespace
}  // namespace blocks
