#include "output/listing/listing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sample_model.hpp"

#include "model/words/merge_reason.hpp"

namespace blocks::output {
namespace {

using samples::contents;
using samples::file_error;
using samples::TemporaryFolder;
using ::testing::HasSubstr;

/// Returns a listing of two blocks with all kinds of entries.
std::string full_listing() {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  model.loads.function = {{0, 0.5}, {0, 1}};
  model.loads.pressures.push_back({1, 2, 10, 20, 0.25});
  model.loads.forces.push_back({1, {3, -4}, 0.125});
  model.layers.push_back({1, 0, 2, 2, 1, 6, 3, 0, 2});
  model.merges.push_back({1, 2, 3, 0.125, 0.2});
  model.merges.push_back({1, 4, 5, 3.0, 3.0});  // The doubles are equal.
  model.exits.push_back({1, 0.005});
  {
    Listing listing(folder / "a.out", false);
    listing.deck_echo({"/some/where/two.deck", "START 10 4\r\nTwo blocks\n\nEND\nSTOP",
                       "Two blocks", "1.0.0", 1982});
    listing.input_echo(model);
    listing.message("warning: block 2 is thin");
    listing.table(model);
    listing.dump(model);
    listing.closing(model);
  }
  return contents(folder / "a.out");
}

// Scripts compare listings, so any change of the text must be intended.
TEST(Listing, IsTheRecordedText) {
  const std::string golden =
      std::string(BLOCKS_SOURCE_DIR) + "/tests/output/golden/two_blocks.out";
  EXPECT_EQ(full_listing(), contents(golden)) << "golden text: " << golden;
}

// The numbers have enough digits to differ.
TEST(MergeRecord, ShowsThatTheWidthIsLessThanTheLimit) {
  EXPECT_EQ(merge_reason(MergeRecord{1, 2, 3, 0.125, 0.2}), "0.125 < 0.2");
  EXPECT_EQ(merge_reason(MergeRecord{1, 2, 3, 3 - 0x1p-40, 3}), "2.999999999999 < 3");
  EXPECT_EQ(merge_reason(MergeRecord{1, 2, 3, 3, 3}),
            "just below 3, by less than doubles resolve");
}

// Appendix D of the report.
TEST(Dump, HasAllThatTheReportStores) {
  const std::string text = full_listing();
  const std::string dump = text.substr(text.find("DUMP    time"));
  for (const char* name :
       {"NC",     "XC",     "YC",     "MASS",   "RMOI", "MAT",   "x",      "y",
        "VX",     "VY",     "TDOT",   "FX",     "FY",   "MOM",   "TAUA11", "TAUA22",
        "TAUI12", "TAUI21", "EDOT11", "EDOT22", "NB",   "NSIDE", "P1",     "P2",
        "TARRIV", "FN",     "FS",     "SIN",    "COS",  "XCP",   "YCP"})
    EXPECT_THAT(dump, HasSubstr(std::string(" ") + name)) << name;
}

TEST(Listing, SeparatesNumbers) {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  for (auto* matrix : {&model.blocks.centroid, &model.blocks.velocity})
    matrix->setConstant(-1.23456789e-300);
  model.blocks.angle.setConstant(-1.23456789e-300);
  Listing(folder / "a.out", false).table(model);
  EXPECT_THAT(contents(folder / "a.out"),
              HasSubstr(" -1.23456789e-300 -1.23456789e-300 -1.23456789e-300"));
}

TEST(Listing, HasAtMost132Columns) {
  std::istringstream lines(full_listing());
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 132U) << line;
}

TEST(Listing, PrintsOnlyTheChosenBlocks) {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  model.output_blocks = {1};
  Listing(folder / "a.out", false).table(model);
  EXPECT_THAT(contents(folder / "a.out"), HasSubstr("        2     free"));
  EXPECT_THAT(contents(folder / "a.out"),
              testing::Not(HasSubstr("        1    fixed")));
}

TEST(Listing, ContinuesAnEarlierOne) {
  const TemporaryFolder folder;
  Listing(folder / "a.out", false).message("first");
  Listing(folder / "a.out", true).message("second");
  EXPECT_EQ(contents(folder / "a.out"), "\nfirst\n\nsecond\n");
}

TEST(Listing, ReplacesAnEarlierOne) {
  const TemporaryFolder folder;
  Listing(folder / "a.out", false).message("first");
  Listing(folder / "a.out", false).message("third");
  EXPECT_EQ(contents(folder / "a.out"), "\nthird\n");
}

TEST(Listing, ErrorsNameTheFileAndTheReason) {
  const TemporaryFolder folder;
  EXPECT_THAT(file_error([&] { Listing(folder / "no/a.out", false); }),
              HasSubstr("no/a.out: No such file or directory"));
  if (std::filesystem::exists("/dev/full")) {
    EXPECT_THAT(file_error([] { Listing("/dev/full", false).message("text"); }),
                HasSubstr("No space left on device"));
  }
}

}  // namespace
}  // namespace blocks::output
