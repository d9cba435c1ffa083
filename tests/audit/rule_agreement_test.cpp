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
#include "tests/audit/fault_of_parts.hpp"

namespace blocks {
namespace {

using audit::Bound;
using audit::Choice;
using audit::ConvexPart;
using audit::ExactPairRule;
using audit::NoEnd;
using audit::PairDecision;
using audit::ThirdOf;
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

using Visit = std::function<void(const PairDecision&, const ExactPairRule&)>;

/// Returns the decisions of program and judge about the pairs where they disagree.
std::string disagreement(const std::vector<NewBlock>& made, std::uint64_t seed,
                         const Visit& visit) {
  const Cluster cluster(made, seed);
  const ExactPairRule judge = cluster.judge();
  std::string found;
  for (int a = 0; a < cluster.blocks.size(); ++a)
    for (int b = a + 1; b < cluster.blocks.size(); ++b) {
      if (!cluster.has_pair(a, b))
        continue;
      const PairDecision decision = judge.decide(a, b);
      visit(decision, judge);
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
  const auto nothing = [](const PairDecision&, const ExactPairRule&) {};
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

  void add(const PairDecision& decision, const ExactPairRule& judge) {
    ++count["pairs"];
    for (const audit::PartDecision& part : decision.parts) {
      add_choice(part.choice);
      count["carried within the slack"] +=
          part.choice == Choice::none && part.chosen >= 0;
      for (const audit::Axis& axis : part.axes)
        if (axis.examined)
          add_axis(axis, judge);
      count["face of several sides in line"] += part.candidates.size() > 5;
      for (const audit::Candidate& candidate : part.candidates)
        add_candidate(candidate);
    }
  }
  void add_choice(Choice choice) {
    switch (choice) {
    case Choice::apart:
      ++count["apart"];
      break;
    case Choice::touching:
      ++count["least axis touches"];
      break;
    case Choice::axis:
      ++count["axis acts"];
      break;
    case Choice::least_axis:
      ++count["no axis left, least axis acts"];
      break;
    case Choice::none:
      ++count["carried"];
      break;
    }
  }
  void add_axis(const audit::Axis& axis, const ExactPairRule& judge) {
    const std::string facing = axis.facing ? ", facing side" : ", no facing side";
    count["inner side skipped"] += axis.skipped;
    if (axis.far)
      switch (axis.far->bound) {
      case Bound::separating_shift:
        ++count["far, largest bound: separating shift"];
        break;
      case Bound::common_diameter:
        ++count["far, largest bound: diameter" + facing];
        break;
      case Bound::third_part:
        ++count["far, largest bound: third part"];
        break;
      }
    for (const audit::Blocking& third : axis.blocking) {
      const bool own = third.whose == ThirdOf::own;
      const int continued = own ? axis.side.part : axis.deepest.part;
      const bool same_block =
          judge.parts()[third.part].block == judge.parts()[continued].block;
      ++count[std::string(third.hides ? "hidden" : "not hidden") +
              " by third part of " + (own ? "own" : "other") +
              (same_block ? " in its block" : "") + facing];
    }
  }
  void add_candidate(const audit::Candidate& candidate) {
    if (candidate.acts && candidate.no_end)
      ++count[candidate.no_end == NoEnd::notch ? "contact in a notch"
                                               : "contact at a joint"];
    count["contacts"] += candidate.acts;
    count["far candidate"] += candidate.far;
    count["candidate outside"] += candidate.between && !candidate.inside;
    count["candidate beyond the end"] += candidate.inside && !candidate.between &&
                                         !candidate.side.inner && !candidate.no_end;
    count["candidate on an inner side"] += candidate.inside && candidate.side.inner;
  }
};

/// The least counts of a test with this many clusters. A branch that is not reached is
/// not tested.
const std::map<std::string, int> min_count = {
    {"apart", 10000},
    {"axis acts", 10000},
    {"candidate beyond the end", 10000},
    {"candidate on an inner side", 200},
    {"candidate outside", 10000},
    {"carried", 2000},
    {"carried within the slack", 20},
    {"contact at a joint", 200},
    {"contact in a notch", 500},
    {"contacts", 10000},
    {"face of several sides in line", 200},
    {"far, largest bound: diameter, facing side", 20},
    {"far, largest bound: diameter, no facing side", 200},
    {"far, largest bound: separating shift", 5},
    {"far, largest bound: third part", 500},
    {"far candidate", 5},
    {"hidden by third part of other, facing side", 2000},
    {"hidden by third part of other, no facing side", 2000},
    {"hidden by third part of other in its block, facing side", 200},
    {"hidden by third part of other in its block, no facing side", 1000},
    {"hidden by third part of own, facing side", 2000},
    {"hidden by third part of own, no facing side", 5000},
    {"hidden by third part of own in its block, facing side", 100},
    {"hidden by third part of own in its block, no facing side", 1000},
    {"inner side skipped", 1000},
    {"least axis touches", 2000},
    {"no axis left, least axis acts", 20},
    {"not hidden by third part of other, facing side", 100},
    {"not hidden by third part of other, no facing side", 5},
    {"not hidden by third part of other in its block, facing side", 10},
    {"not hidden by third part of own, facing side", 200},
    {"not hidden by third part of own, no facing side", 1000},
    {"not hidden by third part of own in its block, facing side", 50},
    {"not hidden by third part of own in its block, no facing side", 200},
    {"pairs", 10000},
};

// The program and the judge were written independently from docs/contact-rule.md.
TEST(ExactPairRule, AgreesWithTheProgramOnRandomClusters) {
  const bool thorough = std::getenv("BLOCKS_THOROUGH") != nullptr;
  const int clusters = thorough ? 1'000'000 : 21'000;
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
        made, seed, [&](const PairDecision& decision, const ExactPairRule& judge) {
          branches.add(decision, judge);
        });
    if (found.empty())
      continue;
    ++disagreements;
    ADD_FAILURE() << "cluster " << k << ", kind " << kind << "\n"
                  << smallest_disagreement(made, seed);
  }
  for (const auto& [name, count] : branches.count)
    RecordProperty(std::regex_replace(name, std::regex(" "), "_"), count);
  for (const auto& [name, min] : min_count)
    EXPECT_GE(branches.count[name], min) << name;
}

}  // namespace
}  // namespace blocks
