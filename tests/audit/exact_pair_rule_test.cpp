// Contacts that the judge of the contact rule decides for simple blocks.
#include "audit/exact_pair_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "audit/rule_cluster.hpp"
#include "audit/story.hpp"

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

// A box is over the joint between two bricks and nearer to their sides than to their
// upper faces. The joint is closed, so the box rests on the upper faces.
TEST(ExactPairRule, StoryExplainsWhyAClosedJointIsHidden) {
  const Cluster cluster =
      cluster_of({box(-2, -1, 2, 1), box(0, -1, 2, 1), box(-0.0625, -0.25, 1, 1)});
  const ExactPairRule judge = cluster.judge();
  const PairDecision decision = judge.decide(0, 2);
  EXPECT_EQ(decision.contacts, (ContactSet{{2, 11}, {8, 1}}));
  const std::vector<std::string> lines = audit::story(judge, 0, 2, decision);
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[0],
            "blocks 1 and 3: corner 3 of block 1 on edge 4 of block 3; corner 1 "
            "of block 3 on edge 2 of block 1");
  EXPECT_EQ(lines[1],
            "axis of edge 3 of block 1: corner 2 of block 3 is 0.0625 deep, facing "
            "edge 1 of block 3: entered: the other end of its facing side is inside; "
            "hidden by a closed joint: at corner 3 of block 1 the surface of edge 2 of "
            "block 1 goes on: neighbours cover 100 % of the stretch (0.25) and 100 % "
            "of the interval (0.25) of edge 3 of block 1, most of it by edge 1 of "
            "block 2; the surface that takes over is edge 2 of block 1; does not act");
  EXPECT_EQ(
      lines[2],
      "axis of edge 2 of block 1: corner 1 of block 3 is 0.25 deep, facing edge 4 "
      "of block 3: not hidden; acts as the surface that has taken over");
  EXPECT_EQ(lines[3], "the choice does not use the other 6 axes");
  EXPECT_EQ(lines.back(), "corner 3 of block 1 on edge 4 of block 3: 0.25 deep: acts");
}

/// Returns the lines of a story as one text.
std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines)
    text += line + "\n";
  return text;
}

// The tip of a wedge has passed the bottom of a notch between two blocks, so its foot
// is beyond the end of each wall.
TEST(ExactPairRule, CornerActsOnBothWallsOfANotch) {
  const geometry::Polygon left = {{-2, -1}, {-2, 2}, {0, 0}, {0, -1}},
                          right = {{0, -1}, {0, 0}, {2, 2}, {2, -1}},
                          wedge = {{0, -0.0625}, {-0.5, 1}, {0.5, 1}};
  const Cluster cluster = cluster_of({left, right, wedge});
  const ExactPairRule judge = cluster.judge();
  for (const auto& [wall, contact] : {std::pair(0, std::pair(8, 1)), {1, {8, 5}}}) {
    const PairDecision decision = judge.decide(wall, 2);
    EXPECT_EQ(decision.contacts, ContactSet{contact});
    EXPECT_EQ(cluster.by_program(wall, 2), decision.contacts);
    EXPECT_NE(text_of(audit::story(judge, wall, 2, decision))
                  .find("its foot is beyond the end, in a notch: acts"),
              std::string::npos);
  }
}

// At the end of a flush floor there is no notch.
TEST(ExactPairRule, CornerBeyondAFlatEndDoesNotAct) {
  const geometry::Polygon left = {{-2, -1}, {-2, 0}, {0, 0}, {0, -1}},
                          right = {{0, -1}, {0, 0}, {2, 0}, {2, -1}},
                          wedge = {{0.0625, -0.0625}, {-0.5, 1}, {0.5, 1}};
  const Cluster cluster = cluster_of({left, right, wedge});
  EXPECT_EQ(cluster.judge().decide(0, 2).contacts, ContactSet{});
  EXPECT_EQ(cluster.judge().decide(1, 2).contacts, (ContactSet{{8, 5}}));
}

// A tip has passed a side that slants away from it. The far side of the block is no
// side by which it has entered.
TEST(ExactPairRule, SidesDeeperThanTheOverlapRegionAreFar) {
  const geometry::Polygon block = {{2, -2}, {0, 0}, {0.5, 0}, {2.5, -2}},
                          tip = {{-0.2, 0.5}, {0.2, 0.5}, {0.002, -0.0021}};
  const Cluster cluster = cluster_of({block, tip});
  const ExactPairRule judge = cluster.judge();
  const PairDecision decision = judge.decide(0, 1);
  EXPECT_EQ(decision.contacts, (ContactSet{{6, 1}}));
  EXPECT_EQ(cluster.by_program(0, 1), decision.contacts);
  EXPECT_NE(text_of(audit::story(judge, 0, 1, decision))
                .find("far: deeper than the overlap region; does not act"),
            std::string::npos);
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
