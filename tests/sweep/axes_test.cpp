// The parameters of a sweep and the runs that they make.
#include "sweep/axes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace blocks::sweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The message of the AxisFault that `action` throws, with its hint.
template <class Action> std::string fault_of(Action&& action) {
  try {
    action();
  } catch (const AxisFault& fault) {
    EXPECT_FALSE(fault.hint.empty()) << fault.what();
    return fault.what();
  }
  return "no fault";
}

TEST(Axes, SeedsAreRangesAndNumbers) {
  EXPECT_THAT(parse_seeds("1-4,9, 7"), ElementsAre(1, 2, 3, 4, 9, 7));
  EXPECT_THAT(parse_seeds("9007199254740990-9007199254740991"),
              ElementsAre(9007199254740990, 9007199254740991));
}

TEST(Axes, SeedsThatAreNoneAreRefused) {
  for (const char* text : {"", "a", "-1", "1.5", "1-", "3,", "1e3", "9007199254740992"})
    EXPECT_THAT(fault_of([&] { parse_seeds(text); }), HasSubstr("a seed is")) << text;
  EXPECT_THAT(fault_of([] { parse_seeds("9-3"); }), HasSubstr("end before they begin"));
  EXPECT_THAT(fault_of([] { parse_seeds("1-5,3"); }), HasSubstr("3 is given twice"));
  EXPECT_THAT(fault_of([] { parse_seeds("0-1000000"); }), HasSubstr("at most"));
  EXPECT_THAT(fault_of([] { parse_seeds("0-9007199254740991"); }),
              HasSubstr("at most"));
}

TEST(Axes, AnAxisHasAFieldAndValues) {
  const Axis axis = parse_axis("MATERIAL[2].rho=2500, 2600");
  EXPECT_EQ(axis.field, "MATERIAL[2].rho");
  EXPECT_THAT(axis.values, ElementsAre("2500", "2600"));
  for (const char* text :
       {"FRICTN", "FRICTN.fric", "=3", "fric=3", ".fric=3", "FRICTN.=3"})
    EXPECT_THAT(fault_of([&] { parse_axis(text); }), HasSubstr("expected CARD.field="))
        << text;
  EXPECT_THAT(fault_of([] { parse_axis("A.b=1,,2"); }), HasSubstr("missing"));
  EXPECT_THAT(fault_of([] { parse_axis("A.b=1,2,1"); }), HasSubstr("twice"));
  EXPECT_THAT(fault_of([] { parse_axis("A.b=.3,0.30"); }), HasSubstr("twice"));
  EXPECT_THAT(parse_axis("A.b='x,\"y',z").values, ElementsAre("'x,\"y'", "z"));
}

TEST(Axes, ATableHasOneRunPerLine) {
  const auto runs = parse_table("\xEF\xBB\xBFseed, FRICTN.fric,MATERIAL[1].name\r\n"
                                "3,.5,\"clay, wet\"\n"
                                "\n"
                                "4,.6,\"a \"\"b\"\"\"");
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].seed, 3U);
  EXPECT_THAT(runs[0].sets,
              ElementsAre("FRICTN.fric=.5", "MATERIAL[1].name=clay, wet"));
  EXPECT_THAT(runs[1].sets, ElementsAre("FRICTN.fric=.6", "MATERIAL[1].name=a \"b\""));
}

TEST(Axes, AFaultyTableIsRefused) {
  EXPECT_THAT(fault_of([] { parse_table(""); }), HasSubstr("names of its columns"));
  EXPECT_THAT(fault_of([] { parse_table("seed\n"); }), HasSubstr("no runs"));
  EXPECT_THAT(fault_of([] { parse_table("seeds\n1"); }), HasSubstr("column 'seeds'"));
  EXPECT_THAT(fault_of([] { parse_table("seed,seed\n1,2"); }),
              HasSubstr("two columns"));
  EXPECT_THAT(fault_of([] { parse_table("seed,A.b\n1"); }), HasSubstr("has 1 values"));
  EXPECT_THAT(fault_of([] { parse_table("seed,A.b\n1,"); }),
              HasSubstr("no value of A.b"));
  EXPECT_THAT(fault_of([] { parse_table("seed\n\"1"); }), HasSubstr("not closed"));
}

TEST(Axes, RunsAreAllCombinationsWithTheSeedsInnermost) {
  const auto runs = combine({}, {{"A.x", {"1", "2"}}, {"B.y", {"3", "4"}}}, {7, 8});
  ASSERT_EQ(runs.size(), 8U);
  EXPECT_EQ(words_of(runs[0]), "seed 7, A.x=1, B.y=3");
  EXPECT_EQ(words_of(runs[1]), "seed 8, A.x=1, B.y=3");
  EXPECT_EQ(words_of(runs[2]), "seed 7, A.x=1, B.y=4");
  EXPECT_EQ(words_of(runs[7]), "seed 8, A.x=2, B.y=4");
  const auto one = combine({}, {}, {});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one.front(), Variation{});
}

TEST(Axes, ParametersGivenTwiceAreRefused) {
  const auto table = parse_table("seed,A.x\n1,5\n2,5");
  EXPECT_THAT(fault_of([&] { combine(table, {}, {1}); }),
              HasSubstr("seeds are given twice"));
  EXPECT_THAT(fault_of([&] {
                combine(table, {{"A.x", {"1"}}}, {});
              }),
              HasSubstr("A.x is given twice"));
  const auto same = parse_table("seed,A.x\n1,5\n2,6\n1,5");
  EXPECT_THAT(fault_of([&] { combine(same, {}, {}); }),
              HasSubstr("are the same: seed 1"));
  EXPECT_THAT(fault_of([] {
                combine({}, {{"A.x", std::vector<std::string>(2000, "1")}},
                        parse_seeds("1-1000"));
              }),
              HasSubstr("at most 1000000"));
}

}  // namespace
}  // namespace blocks::sweep
