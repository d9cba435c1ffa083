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
#include "audit/pair_words.hpp"
#include "dynamics/rules/pair_rule.hpp"

namespace blocks {
namespace {

using audit::Choice;
using audit::ConvexPart;
using audit::Entry;
using audit::ExactPairRule;
using audit::Hiding;
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
      found += audit::tell_wrong_pair(cluster.blocks, a, b, program, decision.contacts);
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
      switch (part.choice) {
      case Choice::apart:
        ++count["apart"];
        break;
      case Choice::least:
        ++count["least axis acts"];
        break;
      case Choice::entered_stands:
        ++count["entered axis stands in"];
        break;
      case Choice::least_stands:
        ++count["least axis stands in"];
        break;
      case Choice::none:
        ++count["no axis"];
        break;
      }
      for (const audit::Axis& axis : part.axes)
        if (axis.examined)
          add(axis);
      for (const audit::Candidate& candidate : part.candidates) {
        count["contacts"] += candidate.acts;
        count["candidate between but not inside"] +=
            candidate.between && !candidate.inside;
        count["candidate inside but not between"] +=
            candidate.inside && !candidate.between;
        count["candidate hidden"] += candidate.hidden.hidden;
        if (candidate.hidden.hidden)
          count["candidate hidden under a rise"] += candidate.hidden.rises;
      }
    }
  }
  void add(const audit::Axis& axis) {
    switch (axis.entry) {
    case Entry::none:
      ++count["not entered"];
      break;
    case Entry::inside:
      ++count["entered inside"];
      break;
    case Entry::foot:
      ++count["entered by the foot"];
      break;
    case Entry::crossing:
      ++count["entered by crossing"];
      break;
    }
    const bool entered = axis.entry != Entry::none;
    switch (axis.hiding) {
    case Hiding::none:
      break;
    case Hiding::inner_side:
      ++count["inner side"];
      break;
    case Hiding::side:
      count["side hidden by a cover"] += entered;
      break;
    case Hiding::inner_facing:
      ++count["inner facing side"];
      break;
    case Hiding::facing:
      count["facing side hidden by a cover"] += entered;
      break;
    case Hiding::corner:
      count[axis.corner_story.joint->side.inner ? "corner hidden at an inner side"
                                                : "corner hidden by a cover"] +=
          entered;
      break;
    }
    if (entered && axis.corner_story.rise_keeps_it_visible)
      ++count["corner visible because of a rise"];
  }
};

/// What a test of this many clusters must reach. A test that reaches nothing shows
/// nothing.
const std::map<std::string, int> least_count = {
    {"apart", 1000},
    {"candidate between but not inside", 1000},
    {"candidate hidden", 1},
    {"candidate inside but not between", 1000},
    {"contacts", 10000},
    {"corner hidden at an inner side", 500},
    {"corner hidden by a cover", 300},
    {"corner visible because of a rise", 500},
    {"entered axis stands in", 300},
    {"entered by crossing", 200},
    {"entered by the foot", 1000},
    {"entered inside", 1000},
    {"facing side hidden by a cover", 300},
    {"inner facing side", 300},
    {"inner side", 1000},
    {"least axis acts", 1000},
    {"least axis stands in", 300},
    {"not entered", 1000},
    {"pairs", 10000},
    {"side hidden by a cover", 300},
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
  ASSERT_EQ(lines.size(), 9U);
  EXPECT_EQ(lines[0],
            "blocks 1 and 3: corner 3 of block 1 on edge 4 of block 3; corner 1 "
            "of block 3 on edge 2 of block 1");
  EXPECT_EQ(
      lines[1],
      "axis of edge 3 of block 1: corner 1 of block 3 is 0.0625 deep, facing edge 1 "
      "of block 3: entered: its corner is outside no other side; hidden by a "
      "closed joint: at corner 3 of block 1 the surface of edge 2 of block 1 goes "
      "on: neighbours cover 100 % of the stretch (0.25) and 100 % of the interval "
      "(0.25) of edge 3 of block 1, most of it by edge 1 of block 2; does not act");
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
