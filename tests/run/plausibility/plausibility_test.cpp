// Every rule of plausibility has a deck that triggers it and one that does not.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/plausibility/plausibility.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A deck of deformable blocks whose E is 1e9.
std::string deformable(const std::string& cards) { return preliminary("") + cards; }
std::string rigid(const std::string& cards) { return preliminary() + cards; }

const std::string square = rectangle(0, 0, 1, 1);
const std::string end = "MOTION, 0.1\n";
const std::string law = "JOINT, 1, .1, 1.E7";

/// Returns the deck with another value of a preliminary card.
std::string with(std::string deck, const std::string& old, const std::string& value) {
  return deck.replace(deck.find(old), old.size(), value);
}

struct RuleCase {
  std::string rule, warning;
  std::string doubtful, plausible;  ///< decks
  friend std::ostream& operator<<(std::ostream& out, const RuleCase& one) {
    return out << one.rule;
  }
};

const RuleCase cases[] = {
    {"friction-in-degrees", "JOINT: the friction coefficient 35 is very large\n",
     rigid(square + "JOINT, 1, 35\n" + end), rigid(square + "JOINT, 1, .7\n" + end)},
    {"friction-in-degrees", "FRICTN: the friction coefficient 35 is very large\n",
     rigid(square + "FRICTN, 35\n" + end), rigid(square + "FRICTN, 5\n" + end)},
    {"weight-of-water", "WATER: water has weight, but no GRAVITY card above",
     rigid(square + "WATER, 1.E4, 1\n0, 1\nGRAVITY, 0, -10\n" + end),
     rigid(square + "GRAVITY, 0, -10\nWATER, 1.E4, 1\n0, 1\n" + end)},
    {"weight-of-water", "WATER: water of density 98100 is heavier than every material",
     rigid(square + "GRAVITY, 0, -.1\nWATER, 9810, 1\n0, 1\n" + end),
     rigid(square + "GRAVITY, 0, -10\nWATER, 9810, 1\n0, 1\n" + end)},
    {"weight-of-water",
     "WATER: gamma over gravity is a density of 1 kg/m3, and that of water is 1000\n",
     with(rigid(square + "GRAVITY, 0, -9.81\nWATER, 9.81, 1\n0, 1\n" + end), "END",
          "UNITS, m, kg, s\nEND"),
     with(rigid(square + "GRAVITY, 0, -9.81\nWATER, 9810, 1\n0, 1\n" + end), "END",
          "UNITS, m, kg, s\nEND")},
    {"outline-crosses-blocks", "REMOVE: 1 block crosses the outline: 3\n",
     rigid("CLOOP, 3, 1, 0\n" + square +
           "REMOVE, , , , 4\n0, 0, 2.1, 2.1\n0, 1, 1, 0\n" + end),
     rigid("CLOOP, 3, 1, 0\n" + square + "REMOVE, , , , 4\n0, 0, 2, 2\n0, 1, 1, 0\n" +
           end)},
    {"outline-crosses-blocks", "FREE: 2 blocks cross the outline: 1, 3\n",
     rigid("CLOOP, 3, 1, 0\n" + rectangle(0, 0, 1, 1, true) +
           "FREE, , , , 4\n.9, 2.1, 2.1, .9\n0, 0, 1, 1\n" + end),
     rigid("CLOOP, 3, 1, 0\n" + rectangle(0, 0, 1, 1, true) +
           "FREE, , , , 4\n1, 2, 2, 1\n0, 0, 1, 1\n" + end)},
    {"outside-domain", "XLIMITS: 1 block outside the domain will be fixed: 1\n",
     rigid(rectangle(9, 0, 11, 1) + end), rigid(rectangle(8, 0, 9, 1) + end)},
    {"edge-of-domain",
     "YLIMITS: 1 block on the edge of the domain will be fixed by the least motion "
     "beyond it: 1\n",
     rigid(rectangle(0, 9, 1, 10) + end),
     rigid(rectangle(0, 8.9, 1, 9.9) + rectangle(0, -10, 1, -9, true) + end)},
    {"behind-plane",
     "SPLANE: 2 free blocks wholly or partly behind the plane, which does not push "
     "blocks out: "
     "1 to 2\n",
     rigid("CLOOP, 3, 2, 0\n" + square + rectangle(-9, -1, 9, 0, true) +
           "SPLANE, 2.5, 1, 2.5, 0\n" + end),
     rigid("CLOOP, 3, 2, 0\n" + square + rectangle(-9, -1, 9, 0, true) +
           "SPLANE, 0, 1, 0, 0\n" + end)},
    {"soft-contacts", "STIFF: the contacts are too soft for the weight of the blocks",
     with(rigid(square + "GRAVITY, 0, -10\n" + end), "1.E7, 1.E7", "1.E5, 1.E5"),
     rigid(square + "GRAVITY, 0, -10\n" + end)},
    {"stiff-contacts",
     "STIFF: the contacts are very stiff for the weight of the blocks",
     with(rigid(square + "GRAVITY, 0, -10\n" + end), "1.E7, 1.E7", "1.E11, 1.E11"),
     with(rigid(square + "GRAVITY, 0, -10\n" + end), "1.E7, 1.E7", "1.E9, 1.E9")},
    {"soft-blocks",
     "MATERIAL: the blocks are too soft for their weight: at rest block 1 is "
     "compressed by about 4.9e+04 % of its height\n",
     with(deformable(square + "GRAVITY, 0, -9.81\n" + end), "1.E9, 4.E8", "20, 8"),
     deformable(square + "GRAVITY, 0, -9.81\n" + end)},
    {"large-ctol", "BOXES: ctol = 0.1 is more than the width of block 1, 0.08\n",
     rigid(rectangle(0, 0, .08, 1) + end), rigid(rectangle(0, 0, .2, 1) + end)},
    {"tiny-block",
     "MOTION: block 3 has the area 9e-08, and the median of all is 1: it makes the "
     "time "
     "step about 3.3e+03 times as short\n",
     rigid(square + rectangle(2, 0, 3, 1) + rectangle(4, 0, 4.0003, .0003) + end),
     with(rigid(square + rectangle(2, 0, 3, 1) + rectangle(4, 0, 4.01, .01) + end),
          "10, 0.1", "10, 0.001")},
    {"coarse-step", "MOTION: FRACTION is blank, and nothing damps",
     with(rigid(square + end), "FRACTION, 0.02", "FRACTION"),
     with(rigid(square + "DAMPING, .1\n" + end), "FRACTION, 0.02", "FRACTION")},
    {"strength-without-bond",
     "JOINT: coh = 1e+07 does not act, because no BOND card bonds joint id 1\n",
     rigid(square + rectangle(0, 1, 1, 2) + law + "\nJPAIR, 1, 1, 1\n" + end),
     rigid(square + rectangle(0, 1, 1, 2) + law + "\nJPAIR, 1, 1, 1\nBOND\n" + end)},
    {"strength-without-bond",
     "JOINT: coh = 1e+07 does not act, because no BOND card bonds joint id 1\n",
     rigid(square + law + "\n" + end), rigid(square + law + ", , , 1.E7\n" + end)},
    {"endless-ramp",
     "GRAVITY: gravity changes during 81, and the deck ends 0.1 after this card\n",
     rigid(square + "GRAVITY, 0, -9,81\n" + end),
     rigid(square + "GRAVITY, 0, -9.8, 1\nMOTION, 1.5\n")},
    {"idle-mscale",
     "MSCALE: masses are scaled only during SOLVE and FOS, and none follows\n",
     rigid(square + "MSCALE\n" + end), rigid(square + "LOCDAMP\nMSCALE\nSOLVE\n")},
    {"no-motion", "the deck has no MOTION, CYCLE or SOLVE", rigid(square),
     rigid(square + end)},
};

class PlausibilityRules : public ::testing::TestWithParam<RuleCase> {};

TEST_P(PlausibilityRules, WarnOfDoubtfulDecksOnly) {
  const TemporaryFolder folder;
  folder.write("doubtful.deck", GetParam().doubtful);
  folder.write("plausible.deck", GetParam().plausible);
  const Outcome doubtful = blocks("check doubtful.deck", folder.path());
  EXPECT_EQ(doubtful.code, 0);
  EXPECT_THAT(doubtful.err, AllOf(HasSubstr("warning: "), HasSubstr(GetParam().warning),
                                  HasSubstr("\n1 warning\n")));
  EXPECT_THAT(blocks("check plausible.deck", folder.path()).err, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Decks, PlausibilityRules, ::testing::ValuesIn(cases));

TEST(PlausibilityTable, HasATestForEachRule) {
  for (const run::PlausibilityRule& rule : run::plausibility_rules())
    EXPECT_TRUE(std::any_of(std::begin(cases), std::end(cases), [&](const auto& one) {
      return one.rule == rule.name;
    })) << rule.name;
}

TEST(PlausibilityTable, IsInTheManual) {
  const std::string page = slurp(fs::path(BLOCKS_SOURCE_DIR) / "docs/plausibility.md");
  for (const run::PlausibilityRule& rule : run::plausibility_rules())
    EXPECT_THAT(page, HasSubstr(fmt::format("\n| {} | {} | {} |\n", rule.name,
                                            rule.condition, rule.remedy)));
}

// The checkpoint of the first deck may have bonds.
TEST(PlausibilityOfARestart, LeavesStrengthAlone) {
  const TemporaryFolder folder;
  run_text(folder, "a", rigid(square + end));
  folder.write("b.deck", "RESTART, a.ckpt.h5\n" + law + "\n" + end);
  EXPECT_THAT(blocks("check b.deck", folder.path()).err, IsEmpty());
}

// A run finds other blocks there than the check did.
TEST(PlausibilityOfAnOutline, IsTestedWhereBlocksHaveMoved) {
  const TemporaryFolder folder;
  const Outcome run =
      run_text(folder, "a",
               rigid(square + rectangle(5, 0, 6, 1) +
                     "SETVEL, 1, 0, 1, 0\nMOTION, 0.2\n"
                     "REMOVE, , , , 4\n-.1, -.1, 1.1, 1.1\n0, 1, 1, 0\n" +
                     end));
  EXPECT_THAT(run.err, HasSubstr("warning: REMOVE: 1 block crosses the outline: 1\n"));
}

// A much too large step is a slip, such as FRACTION in per cent. A single free block
// has fewer contacts than packed ones; frames of the study are such decks.
TEST(FractionCard, IsRefusedAboveThreeTimesTheSafeOne) {
  const TemporaryFolder folder;
  const auto check = [&](const char* fraction,
                         const std::string& other = rectangle(2, 0, 3, 1)) {
    folder.write("a.deck",
                 with(rigid(square + other + "DAMPING, .3\n" + end), "FRACTION, 0.02",
                      std::string("FRACTION, ") + fraction));
    return blocks("check a.deck", folder.path());
  };
  const Outcome refused = check(".14");
  EXPECT_EQ(refused.code, 3);
  EXPECT_THAT(refused.err, HasSubstr("error: DAMPING: FRACTION 0.14 with DAMPING 0.3 "
                                     "is unstable: packed blocks would fly apart\n"));
  for (const Outcome& told : {check(".12"), check(".14", "")}) {
    EXPECT_EQ(told.code, 0);
    EXPECT_THAT(told.err, HasSubstr("may never let packed blocks come to rest"));
  }
  EXPECT_THAT(check(".04").err, IsEmpty());
}

}  // namespace
}  // namespace blocks::testing
