// The contact rule of the program and its judge in whole numbers decide the same
// contacts of random clusters.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <regex>
#include <sstream>

#include "audit/clusters.hpp"
#include "audit/rule_cluster.hpp"
#include "audit/story.hpp"
#include "audit/words.hpp"

namespace blocks {
namespace {

using audit::Choice;
using audit::ConvexPart;
using audit::Entry;
using audit::ExactPairRule;
using audit::HidingPlace;
using audit::PairDecision;
using testing::Cluster;
using testing::ContactSet;
using testing::parts_of;

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

/// Returns the decisions of program and judge about the pairs where they disagree.
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

/// Removes blocks as long as program and judge disagree, and returns the disagreement.
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

/// Counts how often each branch of the rule is reached.
struct Branches {
  std::map<std::string, int> count;

  void add(const PairDecision& decision) {
    ++count["pairs"];
    for (const audit::PartDecision& part : decision.parts) {
      add_choice(part);
      for (const audit::Axis& axis : part.axes)
        if (axis.entry_known)
          add_entry(axis);
      for (const audit::Axis& axis : part.axes)
        if (axis.joints_known)
          add_joints(axis, part);
      count["face of several sides in line"] += part.candidates.size() > 5;
      for (const audit::Candidate& candidate : part.candidates) {
        count["contacts"] += candidate.acts;
        count["far contact"] += candidate.far;
        count["notch contact"] += candidate.acts && candidate.in_notch;
        count["candidate inside, beyond, not in a notch"] +=
            candidate.inside && !candidate.between && !candidate.in_notch;
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
      ++count[std::string("is used instead without entry") + ending];
      break;
    case Choice::no_contact:
      ++count[std::string("is used instead without contact") + ending];
      break;
    case Choice::still_hidden:
      ++count[std::string("is used instead, surfaces hidden") + ending];
      break;
    }
  }
  void add_entry(const audit::Axis& axis) {
    if (axis.far) {
      ++count[axis.facing ? "far axis with a facing side" : "far axis"];
      return;
    }
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

/// The least counts of a test with this many clusters. A branch that is not reached is
/// not tested.
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
    {"entered by the foot", 1500},
    {"entered by the other end", 200},
    {"entered inside", 10000},
    {"face of several sides in line", 200},
    {"far axis", 200},
    {"far axis with a facing side", 200},
    {"far contact", 50},
    {"first entered axis acts", 10000},
    {"hidden by two or more joints", 500},
    {"inner side that is not hidden", 500},
    {"joint of an inner side at the axis side", 500},
    {"joint of an inner side at the corner", 200},
    {"joint of an inner side at the facing side", 200},
    {"least axis touches", 2000},
    {"not entered", 5000},
    {"notch contact", 200},
    {"pairs", 10000},
    {"second surface acts", 50},
    {"is used instead without contact, acts", 200},
    {"is used instead without contact, nothing acts", 50},
    {"is used instead without entry, acts", 200},
    {"is used instead without entry, nothing acts", 50},
    {"is used instead, surfaces hidden, acts", 50},
    {"is used instead, surfaces hidden, nothing acts", 10},
    {"surface takes over", 2000},
    {"surfaces equally deep", 10},
};

// The program and the judge were written independently from docs/contact-rule.md.
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

}  // namespace
}  // namespace blocks
