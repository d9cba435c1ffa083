// The contact rule of the program and its judge in whole numbers give the same
// contacts.
#include "audit/exact_pair_rule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "audit/clusters.hpp"
#include "audit/story.hpp"
#include "audit/words.hpp"
#include "dynamics/rules/pair_rule.hpp"

namespace blocks {
namespace {

using audit::Choice;
using audit::ConvexPart;
using audit::Entry;
using audit::ExactPairRule;
using audit::HidingPlace;
using audit::PairDecision;
using ContactSet = std::vector<std::pair<int, int>>;
using Adjacency = std::vector<std::vector<int>>;

std::vector<ConvexPart> parts_of(const dynamics::BlockParts& cut,
                                 const Blocks& blocks) {
  std::vector<ConvexPart> parts;
  for (int b = 0; b < blocks.size(); ++b)
    for (int part = cut.first_part(b); part < cut.end_part(b); ++part) {
      parts.push_back({b, {}});
      for (int i = 0; i < cut.corners(part); ++i)
        parts.back().corners.push_back(cut.corner(part, i));
    }
  return parts;
}

/// Blocks with the pairs that a list of potential contacts would have.
struct Cluster {
  Blocks before, blocks;  ///< when they were cut, and now
  Adjacency neighbours;
  dynamics::BlockParts cut;

  /// Without a seed all pairs are in the list. The seed decides the order of the list,
  /// which pairs are missing from it, and whether the blocks turn after they have been
  /// cut, so that their corners are rounded once more.
  Cluster(const std::vector<NewBlock>& made, std::optional<std::uint64_t> seed) {
    blocks.append(made);
    cut.make(blocks);
    before = blocks;
    std::mt19937_64 random(seed.value_or(0));
    const auto one_in = [&](unsigned n) { return seed && random() % n == 0; };
    const bool all = !one_in(4);
    neighbours.resize(made.size());
    for (int a = 0; a < blocks.size(); ++a)
      for (int b = 0; b < a; ++b)
        if ((blocks.is_free(a) || blocks.is_free(b)) && (all || !one_in(6))) {
          neighbours[a].push_back(b);
          neighbours[b].push_back(a);
        }
    for (std::vector<int>& some : neighbours)
      std::shuffle(some.begin(), some.end(), random);
    if (one_in(3)) {
      const double angle = 1e-9 * static_cast<double>(random() % 6'000'000'000U);
      const double c = std::cos(angle), s = std::sin(angle);
      Eigen::Matrix2d turn;
      turn << c, -s, s, c;
      blocks.corner = (turn * blocks.corner).eval();
      blocks.centroid = (turn * blocks.centroid).eval();
    }
  }
  ContactSet by_program(int a, int b) const {
    const auto visit_all = [&](int block, const auto& visit) {
      for (const int other : neighbours[block])
        visit(other);
    };
    dynamics::PairScratch scratch;
    dynamics::PairRule<dynamics::ExactPredicates, decltype(visit_all)> rule(
        blocks, cut, visit_all, scratch);
    std::set<std::pair<int, int>> found;
    for (const dynamics::CornerOnEdge& contact : rule.decide(a, b))
      found.emplace(contact.corner, contact.edge);
    return {found.begin(), found.end()};
  }
  ExactPairRule judge() const { return {blocks, parts_of(cut, blocks), neighbours}; }
  bool has_pair(int a, int b) const {
    return std::count(neighbours[a].begin(), neighbours[a].end(), b) > 0;
  }
};

std::string words(const Blocks& blocks) {
  std::ostringstream out;
  out.precision(17);
  for (int b = 0; b < blocks.size(); ++b) {
    out << "  block " << b + 1 << (blocks.is_free(b) ? ", free:" : ", fixed:");
    for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
      out << " (" << blocks.corner(0, c) << ", " << blocks.corner(1, c) << ")";
    out << "\n";
  }
  return out.str();
}

/// What both say about the pairs of a cluster, as far as they disagree.
std::string disagreement(const std::vector<NewBlock>& made, std::uint64_t seed,
                         const std::function<void(const PairDecision&)>& visit) {
  const Cluster cluster(made, seed);
  const ExactPairRule judge = cluster.judge();
  std::string found;
  for (int a = 0; a < cluster.blocks.size(); ++a)
    for (int b = a + 1; b < cluster.blocks.size(); ++b) {
      if (!cluster.has_pair(a, b))
        continue;
      const PairDecision decision = judge.decide(a, b);
      visit(decision);
      const ContactSet program = cluster.by_program(a, b);
      if (program == decision.contacts)
        continue;
      found += audit::tell(cluster.blocks, {a, b, program, decision.contacts});
      for (const std::string& line : audit::story(judge, a, b, decision))
        found += "\n  " + line;
      found += "\n";
    }
  return found;
}

/// Removes blocks from a cluster as long as the disagreement stays.
std::string smallest_disagreement(std::vector<NewBlock> made, std::uint64_t seed) {
  const auto nothing = [](const PairDecision&) {};
  for (std::size_t b = 0; b < made.size();) {
    std::vector<NewBlock> fewer = made;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(b));
    if (disagreement(fewer, seed, nothing).empty())
      ++b;
    else
      made = fewer;
  }
  return disagreement(made, seed, nothing) + words(Cluster(made, seed).blocks);
}

/// How often the branches of the rule were reached.
struct Branches {
  std::map<std::string, int> count;

  void add(const PairDecision& decision) {
    ++count["pairs"];
    for (const audit::PartDecision& part : decision.parts) {
      add_choice(part);
      for (const audit::Axis& axis : part.axes)
        if (axis.examined)
          add_entry(axis);
      for (const audit::Axis& axis : part.axes)
        if (axis.looked_at)
          add_joints(axis, part);
      count["face of several sides in line"] += part.candidates.size() > 5;
      for (const audit::Candidate& candidate : part.candidates) {
        count["contacts"] += candidate.acts;
        count["candidate between but not inside"] +=
            candidate.between && !candidate.inside;
        count["candidate inside but not between"] +=
            candidate.inside && !candidate.between;
      }
    }
  }
  void add_choice(const audit::PartDecision& part) {
    const bool acts = !part.candidates.empty() && part.candidates.back().acts;
    const char* ending = acts ? ", acts" : ", nothing acts";
    switch (part.choice) {
    case Choice::apart:
      ++count["apart"];
      break;
    case Choice::touching:
      ++count["least axis touches"];
      break;
    case Choice::entered:
      ++count["first entered axis acts"];
      break;
    case Choice::surface:
      ++count[part.path.size() == 2 ? "surface takes over" : "second surface acts"];
      break;
    case Choice::inner_side:
      ++count["inner side that is not hidden"];
      break;
    case Choice::no_entry:
      ++count[std::string("stands in without entry") + ending];
      break;
    case Choice::no_contact:
      ++count[std::string("stands in without contact") + ending];
      break;
    case Choice::still_hidden:
      ++count[std::string("stands in, surfaces hidden") + ending];
      break;
    }
  }
  void add_entry(const audit::Axis& axis) {
    switch (axis.entry) {
    case Entry::none:
      ++count["not entered"];
      break;
    case Entry::inside:
      ++count["entered inside"];
      break;
    case Entry::other_end:
      ++count["entered by the other end"];
      break;
    case Entry::foot:
      ++count["entered by the foot"];
      break;
    case Entry::crossing:
      ++count["entered by crossing"];
      break;
    }
  }
  void add_joints(const audit::Axis& axis, const audit::PartDecision& part) {
    count["corner visible because of a rise"] += axis.rise_keeps_it_visible;
    count["hidden by two or more joints"] += axis.hidden_by.size() > 1;
    for (const audit::HidingJoint& hiding : axis.hidden_by) {
      const std::string what =
          hiding.joint.side.inner ? "joint of an inner side at " : "covered joint at ";
      switch (hiding.place) {
      case HidingPlace::axis_side:
        ++count[what + "the axis side"];
        break;
      case HidingPlace::facing_side:
        ++count[what + "the facing side"];
        break;
      case HidingPlace::corner:
        ++count[what + "the corner"];
        break;
      }
      if (hiding.surface != axis.taken_over_by &&
          part.axes[hiding.surface].depth == part.axes[axis.taken_over_by].depth)
        ++count["surfaces equally deep"];
    }
  }
};

/// What a test of this many clusters must reach. A test that reaches nothing shows
/// nothing.
const std::map<std::string, int> least_count = {
    {"apart", 10000},
    {"candidate between but not inside", 10000},
    {"candidate inside but not between", 10000},
    {"contacts", 10000},
    {"corner visible because of a rise", 1000},
    {"covered joint at the axis side", 200},
    {"covered joint at the corner", 500},
    {"covered joint at the facing side", 200},
    {"entered by crossing", 500},
    {"entered by the foot", 2000},
    {"entered by the other end", 200},
    {"entered inside", 10000},
    {"face of several sides in line", 200},
    {"first entered axis acts", 10000},
    {"hidden by two or more joints", 500},
    {"inner side that is not hidden", 500},
    {"joint of an inner side at the axis side", 500},
    {"joint of an inner side at the corner", 200},
    {"joint of an inner side at the facing side", 200},
    {"least axis touches", 2000},
    {"not entered", 5000},
    {"pairs", 10000},
    {"second surface acts", 50},
    {"stands in without contact, acts", 200},
    {"stands in without contact, nothing acts", 50},
    {"stands in without entry, acts", 200},
    {"stands in without entry, nothing acts", 50},
    {"stands in, surfaces hidden, acts", 100},
    {"stands in, surfaces hidden, nothing acts", 10},
    {"surface takes over", 2000},
    {"surfaces equally deep", 10},
};

// The program and the judge were written from docs/contact-rule.md independently.
TEST(ExactPairRule, AgreesWithTheProgramOnRandomClusters) {
  const bool thorough = std::getenv("BLOCKS_THOROUGH") != nullptr;
  const int clusters = thorough ? 1'000'000 : 18'000;
  Branches branches;
  int disagreements = 0;
  for (int k = 0; k < clusters && disagreements < 10; ++k) {
    const auto seed = static_cast<std::uint64_t>(k);
    const int kind = k % testing::Clusters::kinds;
    const std::vector<NewBlock> made = testing::Clusters(seed).make(kind);
    const Cluster cluster(made, seed);
    const std::vector<ConvexPart> parts = parts_of(cluster.cut, cluster.before);
    for (int b = 0; b < cluster.before.size(); ++b)
      EXPECT_EQ(audit::fault_of_parts(cluster.before, b, parts), "") << "cluster " << k;
    const std::string found = disagreement(
        made, seed, [&](const PairDecision& decision) { branches.add(decision); });
    if (found.empty())
      continue;
    ++disagreements;
    ADD_FAILURE() << "cluster " << k << ", kind " << kind << "\n"
                  << smallest_disagreement(made, seed);
  }
  for (const auto& [name, count] : branches.count)
    RecordProperty(std::regex_replace(name, std::regex(" "), "_"), count);
  for (const auto& [name, least] : least_count)
    EXPECT_GE(branches.count[name], least) << name;
}

geometry::Polygon box(double x, double y, double w, double h) {
  return {{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}};
}

Cluster cluster_of(const std::vector<geometry::Polygon>& outlines) {
  std::vector<NewBlock> made;
  for (const geometry::Polygon& outline : outlines)
    made.push_back({outline, 1, 1.0});
  return {made, {}};
}

// Corners 0 to 3 are those of the lower box: lower left, upper left, and so on.
TEST(ExactPairRule, AlignedFacesCarryFourContactsAndOffsetFacesTwo) {
  const auto contacts = [](double x, double y) {
    return cluster_of({box(0, 0, 2, 1), box(x, y, 2, 1)}).judge().decide(0, 1).contacts;
  };
  EXPECT_EQ(contacts(0, 0.875), (ContactSet{{1, 7}, {2, 7}, {4, 1}, {7, 1}}));
  EXPECT_EQ(contacts(0.5, 0.875), (ContactSet{{2, 7}, {4, 1}}));
  EXPECT_EQ(contacts(0.5, 1.0), ContactSet{});
}

/// Contacts of two blocks that overlap by `overlap` along a horizontal edge of length
/// 2; the upper one is shifted and turned. All are on the common faces, and the judge
/// agrees.
void expect_contacts_of_faces(const geometry::Polygon& lower, geometry::Polygon upper,
                              double overlap, double shift, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec2& corner : upper)
    corner = {c * corner.x() - s * corner.y() + shift,
              s * corner.x() + c * corner.y() - overlap};
  const Cluster cluster = cluster_of({lower, upper});
  const ContactSet contacts = cluster.judge().decide(0, 1).contacts;
  EXPECT_EQ(cluster.by_program(0, 1), contacts);
  // turned about its left end, which may be beyond that of the lower one
  if (overlap > 2 * std::abs(shift * angle)) {
    EXPECT_FALSE(contacts.empty()) << overlap << ' ' << shift << ' ' << angle;
  }
  for (const auto& [corner, edge] : contacts)
    EXPECT_LT(cluster.judge().overlap(corner, edge),
              2 * (overlap + 2 * std::abs(angle)))
        << overlap << ' ' << shift << ' ' << angle;
}

// Blocks of a layer share whole edges. If both have acute angles at its ends, no corner
// is inside the other block; if it is a rectangle's, either end may come first.
TEST(ExactPairRule, SharedEdgesActWhateverAnglesTheyEndIn) {
  for (const double inset : {0.6, 0.2, 0.0, -0.4})  // of the far edges
    for (const double overlap : {1e-9, 1e-6, 1e-3})
      for (const double shift : {0.0, 1e-9, -1e-7, 3e-6, -1e-4, 1e-3})
        for (const double angle : {0.0, 1e-10, -1e-7, 1e-4})
          expect_contacts_of_faces({{inset, -1}, {0, 0}, {2, 0}, {2 - inset, -1}},
                                   {{0, 0}, {inset, 1}, {2 - inset, 1}, {2, 0}},
                                   overlap, shift, angle);
}

// One unit in the last place decides, since nothing is rounded.
TEST(ExactPairRule, OverlapIsASignNotANumber) {
  const auto contacts = [](double y) {
    return cluster_of({box(0, -1, 4, 1), box(1, y, 1, 1)})
        .judge()
        .decide(0, 1)
        .contacts;
  };
  EXPECT_EQ(contacts(-0x1p-1074), (ContactSet{{4, 1}, {7, 1}}));
  EXPECT_EQ(contacts(0x1p-1074), ContactSet{});
}

// Sines of angles 1e-12 to either side of ten degrees judge the condition.
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

// A box lies over the joint between two bricks and is nearer to their sides than to
// their upper faces: the joint is closed, so it rests on the upper faces.
TEST(ExactPairRule, AClosedJointIsHiddenAndTheStorySaysWhy) {
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

// The corners of a notched block count from 0, lower left.
TEST(ExactPairRule, PartsThatDoNotTileTheBlockAreFound) {
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
