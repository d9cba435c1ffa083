// The command line: exit codes, older files, standard input, the card reference and
// figures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "deck/cards/card_table.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string falling =
    preliminary() + rectangle(0, 0, 1, 1) + "GRAVITY, 0, -10\nPLOTS, 0.1\n";

TEST(ExitCode, ShowsTheKindOfFault) {
  const TemporaryFolder folder;
  folder.write("good.deck", falling + "CYCLE, 3\n");
  folder.write("bad.deck", falling + "CYLCE, 3\n");
  const auto code = [&](const std::string& arguments) {
    return blocks(arguments, folder.path()).code;
  };
  EXPECT_EQ(code("run good.deck"), 0);
  EXPECT_EQ(code("--help"), 0);
  EXPECT_EQ(code("--version"), 0);
  EXPECT_EQ(code(""), 2);
  EXPECT_EQ(code("run"), 2);
  EXPECT_EQ(code("walk good.deck"), 2);
  EXPECT_EQ(code("run good.deck --fast"), 2);
  EXPECT_EQ(code("run good.deck --set dt"), 2);
  EXPECT_EQ(code("run good.deck --time-limit -1"), 2);
  EXPECT_EQ(code("run bad.deck"), 3);
  EXPECT_EQ(code("check bad.deck"), 3);
  EXPECT_EQ(code("run good.deck --set CYLCE.ncycle=4"), 3);
  EXPECT_EQ(code("run good.deck --stop-after 0"), 2);
  EXPECT_EQ(code("run good.deck --stop-after 2"), 75);
  EXPECT_EQ(code("run good.deck --restart good.ckpt.h5"), 0);
  EXPECT_EQ(code("run good.deck --restart absent.ckpt.h5"), 5);
  EXPECT_EQ(code("run absent.deck"), 5);
  EXPECT_EQ(code("run ."), 5);
  EXPECT_EQ(code("run good.deck -o good.deck/good"), 5);
}

TEST(OutputOption, CreatesTheFolder) {
  const TemporaryFolder folder;
  folder.write("a.deck", falling + "CYCLE, 3\n");
  for (const std::string name : {"new/folder/", "another/new/folder/a"}) {
    const Outcome run = blocks("run a.deck -o " + name, folder.path());
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string written = name.ends_with('/') ? name + "a" : name;
    for (const char* ending : {".out", ".vtkhdf", ".ckpt.h5", ".summary.json"})
      EXPECT_TRUE(folder.holds(written + ending)) << written << ending;
  }
}

TEST(OutputOption, CreatesNoFolderIfTheDeckIsInvalid) {
  const TemporaryFolder folder;
  folder.write("a.deck", falling + "CYLCE, 3\n");
  EXPECT_EQ(blocks("run a.deck -o new/", folder.path()).code, 3);
  EXPECT_FALSE(folder.holds("new"));
}

TEST(OutputOption, TellsWhyAFolderCannotBeCreated) {
  const TemporaryFolder folder;
  folder.write("a.deck", falling + "CYCLE, 3\n");
  folder.write("file", "");
  const Outcome run = blocks("run a.deck -o file/a", folder.path());
  EXPECT_EQ(run.code, 5);
  EXPECT_EQ(run.err, "blocks: error: cannot create the folder file: Not a directory\n");
}

TEST(OutputOption, TellsHowToCreateTheFolderOfAFigure) {
  const TemporaryFolder folder;
  run_text(folder, "a", falling + "CYCLE, 3\n", "-q");
  const Outcome plot = blocks("plot a.vtkhdf -o new/a.png", folder.path());
  EXPECT_EQ(plot.code, 5);
  EXPECT_EQ(plot.err, "blocks: error: cannot write new/a.png: there is no folder new; "
                      "create it with mkdir -p new\n");
}

TEST(Environment, RefusesAnUnknownInstructionSet) {
  const TemporaryFolder folder;
  folder.write("good.deck", falling + "CYCLE, 3\n");
  ASSERT_EQ(setenv("BLOCKS_SIMD", "avx", 1), 0);
  const Outcome misspelt = blocks("run good.deck", folder.path());
  ASSERT_EQ(setenv("BLOCKS_SIMD", "baseline", 1), 0);
  const Outcome known = blocks("run good.deck", folder.path());
  ASSERT_EQ(unsetenv("BLOCKS_SIMD"), 0);
  EXPECT_EQ(misspelt.code, 2);
  EXPECT_THAT(misspelt.err,
              StartsWith("blocks: error: BLOCKS_SIMD=avx is no instruction set of this "
                         "machine; there are baseline"));
  EXPECT_FALSE(folder.holds("good.out.bak"));  // Only the second run has written files.
  EXPECT_EQ(known.code, 0);
}

TEST(ExitCode, IsFourIfTheRunIsUnstable) {
  const TemporaryFolder folder;
  folder.write("wild.deck", preliminary() + rectangle(0, 0, 1, 1) +
                                "GRAVITY, 1.E308, 1.E308\nCYCLE, 99\n");
  const Outcome run = blocks("run wild.deck", folder.path());
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_EQ(summary(folder, "wild")["status"], "unsound");
}

// The listing ends with the overlaps of the step that failed.
TEST(Unsound, ListingHasTheOverlapsOfTheLastStep) {
  const TemporaryFolder folder;
  const auto listing = [&](const std::string& options) {
    EXPECT_EQ(blocks("run shot.deck -o shot " + options, folder.path()).code, 4);
    return slurp(folder / "shot.out");
  };
  for (const std::string rigid : {"RIGID\n", ""}) {
    folder.write("shot.deck",
                 "START, 20, 4\nA SHOT\nXLIMITS, -12, 12\nYLIMITS, -12, 18\n"
                 "BOXES, 13, 10, 0.1\nSTIFF, 1.E6, 1.E6\nFRACTION, 0.02\n"
                 "MATERIAL, 1, 1.E9, 4.E8, 2000\n" +
                     rigid + "END\n" + rectangle(1, 0, 2, 1) +
                     rectangle(1.3, 1.05, 1.7, 1.45) +
                     "SETVEL, 2, 0, 0, -25, 0\nDAMPING, 0.2\nMOTION, 3\n");
    const std::string plain = listing("");
    EXPECT_EQ(plain, listing("--audit=1"));
    const std::string words = "worst overlap";
    EXPECT_GT(std::stod(plain.substr(plain.rfind(words) + words.size())), 0.05);
  }
}

TEST(TimeLimit, DoesNotStopARunAtItsEnd) {
  const TemporaryFolder folder;
  folder.write("short.deck", falling + "CYCLE, 40\n");
  EXPECT_EQ(blocks("run short.deck --time-limit 0.0001", folder.path()).code, 0);
}

// The square of the spin overflows, so that the rotation is NaN.
TEST(ExitCode, IsFourIfARotationOverflows) {
  for (const char* kind : {"RIGID\n", ""}) {
    const TemporaryFolder folder;
    folder.write("spun.deck", preliminary(kind) + rectangle(0, 0, 1, 1) +
                                  "SETVEL, 1, 0, 0, 0, -1.E308\nCYCLE, 9\n");
    const Outcome run = blocks("run spun.deck", folder.path());
    EXPECT_EQ(run.code, 4) << kind << run.err;
  }
}

TEST(TimeLimit, LeavesACheckpointToContinueFrom) {
  const TemporaryFolder folder;
  folder.write("long.deck", falling + "CYCLE, 900000000\n");
  const Outcome run = blocks("run long.deck --time-limit 0.2", folder.path());
  EXPECT_EQ(run.code, 75) << run.err;
  const auto stopped = summary(folder, "long");
  EXPECT_EQ(stopped["status"], "time limit");
  EXPECT_GE(stopped["wall_seconds"].get<double>(), 0.2);
  run_text(folder, "on", "RESTART\nCYCLE, 10\n", "-o long");
  EXPECT_EQ(summary(folder, "long")["steps"], stopped["steps"].get<long>() + 10);
}

TEST(OlderResults, AreKept) {
  const TemporaryFolder folder;
  run_text(folder, "fall", falling + "CYCLE, 3\n");
  const std::string listing = slurp(folder / "fall.out"),
                    results = slurp(folder / "fall.vtkhdf");
  run_text(folder, "fall", falling + "CYCLE, 4\n");
  EXPECT_EQ(slurp(folder / "fall.out.bak"), listing);
  EXPECT_EQ(slurp(folder / "fall.vtkhdf.bak"), results);
  EXPECT_NE(slurp(folder / "fall.out"), listing);
}

// The deck has the style of 1982. The same deck in today's style has the same results.
TEST(StandardInput, RunsADeckOf1982) {
  const std::string old = "START,10,4\n"
                          "TWO BRICKS ON A FLOOR\n"
                          "XLIMITS,-5.,5.\nYLIMITS,-5.,5.\nBOXES,10,10,\n"
                          "STIFF,1.D7,1.D7\nFRACTION,.02\nMATERIAL,1,,,2000.\nRIGID\n"
                          "END\n"
                          "CREATE,4,1,1\n-4.,-4.,\n4.,4.\n-1.,0.,0.,\n-1.\n"
                          "CLOOP,2,0.,.5\n"
                          "CREATE,4,1\n0.,0.,1.,1.\n0.,.5,.5,0.\n"
                          "GRAVITY,,-9.81\nFRICTN,.5\nDAMPING,.3\n"
                          "OUTPUT,.1\nMOTION,.1\nSTOP\n";
  const std::string today = "$ comment\nstart 10 4\nTWO BRICKS ON A FLOOR\n"
                            "xlimits -5 5\nylimits -5 5\nboxes, 10, 10, 0.1\n"
                            "stiff 1e7 1e7 ! stiffness\nfraction 2e-2\n"
                            "material, 1, 0, 0, 2e3\nrigid\nend\n\n"
                            "create 4 1 1\n-4 -4 4 4\n-1 0 0 -1\n"
                            "cloop 2 0 0.5\ncreate 4 1\n0 0 1 1\n0 0.5 0.5 0\n"
                            "gravity 0 -9.81\nfrictn 0.5\ndamping 0.3\n"
                            "output 0.1\nmotion 0.1\n";
  const TemporaryFolder folder;
  const Outcome run = blocks("run -", folder.path(), old);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = summary(folder, "blocks");
  EXPECT_EQ(json["title"], "TWO BRICKS ON A FLOOR");
  run_text(folder, "today", today);
  EXPECT_EQ(json["state_hash"], summary(folder, "today")["state_hash"]);
}

TEST(StandardInput, IsNamedInMessages) {
  const TemporaryFolder folder;
  const Outcome bad = blocks("check -", folder.path(), "START\n");
  EXPECT_EQ(bad.code, 3);
  EXPECT_THAT(bad.err, StartsWith("<standard input>:1:"));
}

TEST(JsonOption, PrintsNothingButTheSummary) {
  const TemporaryFolder folder;
  const Outcome run = run_text(folder, "fall", falling + "CYCLE, 3\n", "--json");
  EXPECT_EQ(nlohmann::json::parse(run.out), summary(folder, "fall"));
}

TEST(SetOption, ReplacesAFieldOfTheRun) {
  const TemporaryFolder folder;
  run_text(folder, "fall", falling + "CYCLE, 3\n", "--set cycle.NCYCLE=5");
  EXPECT_EQ(summary(folder, "fall")["steps"], 5);
}

TEST(SetOption, ReplacesAFieldOfOneOfSeveralCards) {
  const TemporaryFolder folder;
  run_text(folder, "fall", falling + "CYCLE, 3\nCYCLE, 4\n",
           "--set 'CYCLE[2].ncycle=10'");
  EXPECT_EQ(summary(folder, "fall")["steps"], 13);
}

// Every line of the list is accepted and has the value that the deck has without it.
TEST(SetOption, AcceptsTheListOfADeckWithoutAnyChange) {
  const TemporaryFolder folder;
  const fs::path deck =
      fs::path(BLOCKS_SOURCE_DIR) / "decks/every_card/every_card.deck";
  const Outcome listed = blocks("cards --set '" + deck.string() + "'", folder.path());
  ASSERT_EQ(listed.code, 0) << listed.err;
  EXPECT_THAT(listed.out, HasSubstr("\nMATERIAL[2].rho="));
  std::string sets;
  std::istringstream lines(listed.out);
  for (std::string line; std::getline(lines, line);)
    sets += " --set \"" + line + '"';
  const std::string run = "run -q '" + deck.string() + "' --stop-after 50 -o ";
  const std::string plain = blocks(run + "plain", folder.path()).err;
  EXPECT_EQ(blocks(run + "set" + sets, folder.path()).err, plain);
  EXPECT_EQ(summary(folder, "set")["state_hash"],
            summary(folder, "plain")["state_hash"]);
}

TEST(SetOption, ListsNothingOfAFaultyDeck) {
  const TemporaryFolder folder;
  folder.write("bad.deck", falling + "CYLCE, 3\n");
  const Outcome listed = blocks("cards --set bad.deck", folder.path());
  EXPECT_EQ(listed.code, 3);
  EXPECT_EQ(listed.out, "");
  EXPECT_THAT(listed.err, HasSubstr("unknown card 'CYLCE'"));
}

TEST(Cards, AreAllListed) {
  const TemporaryFolder folder;
  const Outcome all = blocks("cards", folder.path());
  EXPECT_EQ(all.code, 0);
  for (const std::string_view name : deck::card_names()) {
    EXPECT_THAT(all.out, HasSubstr("\n  " + std::string(name) + " "));
    const Outcome one = blocks("cards " + std::string(name), folder.path());
    EXPECT_EQ(one.code, 0);
    EXPECT_THAT(one.out, StartsWith(std::string(name)));
  }
}

TEST(Cards, AreFoundInAnyLetterCase) {
  const TemporaryFolder folder;
  EXPECT_EQ(blocks("cards layer", folder.path()).out,
            blocks("cards LAYER", folder.path()).out);
}

TEST(Cards, RefusesAnUnknownCard) {
  const TemporaryFolder folder;
  const Outcome none = blocks("cards LAYRE", folder.path());
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, StartsWith("blocks: error: there is no card LAYRE\n"));
}

TEST(Cards, SuggestsTheNameOfAMisspeltCard) {
  const TemporaryFolder folder;
  EXPECT_EQ(blocks("cards LAYR", folder.path()).err,
            "blocks: error: there is no card LAYR\n  hint: did you mean LAYER?\n");
}

TEST(WrongCommand, GetsASuggestion) {
  const TemporaryFolder folder;
  const Outcome wrong = blocks("runn small.deck", folder.path());
  EXPECT_EQ(wrong.code, 2);
  EXPECT_EQ(wrong.err, "blocks: error: there is no command runn\n  hint: did you mean "
                       "run? blocks --help shows what is possible\n");
}

// Without the option, 4 is the deck.
TEST(WrongOption, IsBlamedInsteadOfTheDeck) {
  const TemporaryFolder folder;
  for (const char* line : {"run --thread 4 small.deck", "run --thread=4"}) {
    const Outcome wrong = blocks(line, folder.path());
    EXPECT_EQ(wrong.code, 2);
    EXPECT_EQ(wrong.err,
              "blocks: error: blocks run has no option --thread\n  hint: did "
              "you mean --threads? blocks run --help shows what is possible\n");
  }
}

TEST(WrongOption, OfANestedCommandIsBlamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(blocks("study contacts --lst", folder.path()).err,
              StartsWith("blocks: error: blocks study contacts has no option --lst\n  "
                         "hint: did you mean --list?"));
}

TEST(Cards, AreThoseOfTheReferencePage) {
  const TemporaryFolder folder;
  EXPECT_EQ(blocks("cards --markdown", folder.path()).out,
            slurp(fs::path(BLOCKS_SOURCE_DIR) / "docs/cards.md"));
}

class Plot : public ::testing::Test {
 protected:
  void SetUp() override { run_text(folder_, "fall", falling + "MOTION, 0.2\n"); }
  Outcome plot(const std::string& arguments) {
    return blocks("plot " + arguments, folder_.path());
  }
  TemporaryFolder folder_;
};

// The first bytes of a file identify its format.
TEST_F(Plot, WritesTheFormatOfTheFileExtension) {
  for (const auto& [name, begin] :
       {std::pair{"a.png", "\x89PNG"}, {"a.svg", "<?xml"}, {"a.pdf", "%PDF"}}) {
    const Outcome outcome = plot(std::string("fall.vtkhdf -o ") + name);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(slurp(folder_ / name), StartsWith(begin));
  }
}

TEST_F(Plot, WritesPngUnlessAFileIsNamed) {
  EXPECT_EQ(plot("fall.vtkhdf").code, 0);
  EXPECT_TRUE(folder_.holds("fall.png"));
}

TEST_F(Plot, ShowsTheChosenTimeAndQuantity) {
  const auto figure = [&](const std::string& options) {
    EXPECT_EQ(plot("fall.vtkhdf -o a.svg " + options).code, 0) << options;
    return slurp(folder_ / "a.svg");
  };
  EXPECT_NE(figure("-t 0"), figure("-t 0.2"));
  EXPECT_EQ(figure("-t 0.2"), figure(""));
  EXPECT_NE(figure("--colour speed"), figure("--colour material"));
}

TEST_F(Plot, NamesTheChoicesIfAnOptionIsWrong) {
  const Outcome ending = plot("fall.vtkhdf -o a.bmp");
  EXPECT_NE(ending.code, 0);
  EXPECT_THAT(ending.err, HasSubstr(".mp4 or .gif (a movie), found 'a.bmp'"));
  const Outcome quantity = plot("fall.vtkhdf -o a.png --colour heat");
  EXPECT_NE(quantity.code, 0);
  EXPECT_THAT(quantity.err,
              HasSubstr("there is no quantity 'heat': choose material, family, "
                        "joint, bond, opening, shear_displacement, "
                        "water_pressure, speed, displacement, rotation, x"));
  EXPECT_THAT(plot("fall.vtkhdf -o a.png --colour speedd").err,
              HasSubstr("there is no quantity 'speedd'; did you mean speed?"));
  const Outcome time = plot("fall.vtkhdf -o a.png --time 99");
  EXPECT_EQ(time.code, 2);
  EXPECT_THAT(time.err, HasSubstr("fall.vtkhdf has times 0 to "));
  EXPECT_FALSE(folder_.holds("a.bmp") || folder_.holds("a.png"));
}

TEST_F(Plot, RefusesFilesThatAreNoResults) {
  EXPECT_EQ(plot("absent.vtkhdf").code, 5);
  EXPECT_EQ(plot("fall.ckpt.h5").code, 5);
  EXPECT_EQ(plot("fall.deck").code, 5);
}

}  // namespace
}  // namespace blocks::testing
