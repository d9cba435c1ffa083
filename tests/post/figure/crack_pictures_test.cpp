// Pictures, histories and exported numbers of blocks that split during the run.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "post/chart/history.hpp"
#include "post/figure/figure.hpp"
#include "post/read/crack_tracker.hpp"
#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string crack_stroke = "stroke[:=]\"?rgb\\(90%, ?5%, ?0%\\)";

/// The results of cracked.deck, made once.
class CrackPictures : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const std::string deck =
        std::string(BLOCKS_SOURCE_DIR) + "/tests/post/cracked.deck";
    ASSERT_EQ(blocks("run " + deck + " -q -o cracked", folder_->path()).code, 0);
  }
  static void TearDownTestSuite() { delete folder_; }
  static Outcome run(const std::string& arguments) {
    return blocks(arguments, folder_->path());
  }
  static post::ResultsReader results() {
    return post::ResultsReader((*folder_ / "cracked.vtkhdf").string());
  }
  static TemporaryFolder* folder_;
};
TemporaryFolder* CrackPictures::folder_ = nullptr;

/// The rows of a CSV file, with the texts by the name of the column.
std::vector<std::map<std::string, std::string>> table(const std::string& text) {
  std::istringstream lines(text);
  std::string line, field;
  std::getline(lines, line);
  std::vector<std::string> names;
  for (std::istringstream head(line); std::getline(head, field, ',');)
    names.push_back(field);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (const std::string& column : names) {
      std::getline(fields, field, ',');
      rows.back()[column] = field;
    }
  }
  return rows;
}

// Both faces of a crack are as long as its chord, whatever happens to them later: a
// later crack may cut them, but they remain faces. Strains here are below 1e-3.
TEST_F(CrackPictures, FollowTheFacesOfCracks) {
  const post::ResultsReader from = results();
  const auto cracks = from.cracks();
  ASSERT_GE(cracks.size(), 2U);
  post::ResultsTracker tracker(from);
  std::set<long> counts;
  for (long i = 0; i < from.frames(); ++i) {
    const post::Frame now = from.frame(i);
    const post::CrackedBlocks& blocks = tracker.at(i, now);
    counts.insert(now.cracks);
    std::vector<double> length(cracks.size(), 0.0);
    for (std::size_t b = 0; b < now.outlines.size(); ++b)
      for (std::size_t k = 0; k < now.outlines[b].size(); ++k)
        if (const int crack = blocks.face(static_cast<int>(b), k); crack > 0)
          length[static_cast<std::size_t>(crack) - 1] +=
              (now.outlines[b][(k + 1) % now.outlines[b].size()] - now.outlines[b][k])
                  .norm();
    for (std::size_t c = 0; c < cracks.size(); ++c)
      EXPECT_NEAR(length[c],
                  static_cast<long>(c) < now.cracks ? 2.0 * cracks[c].length() : 0.0,
                  2e-3 * cracks[c].length())
          << "crack " << c + 1 << " in frame " << i;
  }
  EXPECT_GT(counts.size(), 1U);
}

// The centroid of a piece is half a metre from that of its block, but the material has
// moved by less than its speed times the time.
TEST_F(CrackPictures, CountDisplacementsFromThePlaceOfTheMaterial) {
  const post::ResultsReader from = results();
  std::vector<post::Curve> curves;
  const int blocks = from.frame(from.frames() - 1).size();
  for (int b = 1; b <= blocks; ++b) {  // of the centroid, and of corner 1
    curves.push_back(quantities::parse_curve(fmt::format("displacement:{}", b)));
    curves.push_back(quantities::parse_curve(fmt::format("displacement:{}.1", b)));
  }
  curves.push_back(quantities::parse_curve("speed:max"));
  const post::History history = post::read_history({&from}, curves);
  double fastest = 0.0;
  for (const double speed : history.series.back().values)
    fastest = std::max(fastest, speed);
  const auto cracks = from.cracks();
  const auto born = [&](int b) {
    const auto crack = std::find_if(cracks.begin(), cracks.end(),
                                    [&](const post::Crack& c) { return c.child == b; });
    return crack == cracks.end() ? 0.0 : crack->time;
  };
  for (const post::Crack& crack : cracks)
    for (const int b : {crack.parent, crack.child})
      for (const std::size_t at :
           {2 * static_cast<std::size_t>(b) - 2, 2 * static_cast<std::size_t>(b) - 1})
        for (std::size_t i = 0; i < history.time.size(); ++i) {
          const double moved = history.series[at].values[i];
          if (history.time[i] < born(b))
            EXPECT_TRUE(std::isnan(moved)) << history.series[at].label;
          else
            EXPECT_LE(moved, 2.0 * fastest * history.time[i] + 1e-3)
                << history.series[at].label << " at " << history.time[i];
        }
}

TEST_F(CrackPictures, DrawCracksUnlessTheyAreTurnedOff) {
  ASSERT_EQ(run("plot cracked.vtkhdf -t 0 -o first.svg").code, 0);
  ASSERT_EQ(run("plot cracked.vtkhdf -o last.svg").code, 0);
  ASSERT_EQ(run("plot cracked.vtkhdf --no-cracks -o without.svg").code, 0);
  const std::string first = slurp(*folder_ / "first.svg"),
                    last = slurp(*folder_ / "last.svg"),
                    without = slurp(*folder_ / "without.svg");
  const std::regex stroke(crack_stroke);
  EXPECT_FALSE(std::regex_search(first, stroke));
  EXPECT_TRUE(std::regex_search(last, stroke));
  EXPECT_FALSE(std::regex_search(without, stroke));
  EXPECT_THAT(first, Not(HasSubstr(">crack</text>")));
  EXPECT_THAT(last, HasSubstr(">crack</text>"));
  EXPECT_THAT(last, ContainsRegex("[0-9]+ cracks"));
}

TEST_F(CrackPictures, ColourPiecesByTheirBlock) {
  ASSERT_EQ(run("plot cracked.vtkhdf --colour family -o family.svg").code, 0);
  const std::string family = slurp(*folder_ / "family.svg");
  for (const char* entry :
       {">whole blocks</text>", ">from block 1</text>", ">from block 2</text>"})
    EXPECT_THAT(family, HasSubstr(entry));
  EXPECT_THAT(family, Not(HasSubstr(">from block 3</text>")));
  const Outcome whole = run("plot cracked.vtkhdf --colour family -t 0 -o none.svg");
  EXPECT_EQ(whole.code, 2);
  EXPECT_THAT(whole.err, HasSubstr("no block has split at the times drawn"));
}

TEST_F(CrackPictures, ExportEachTimeWithItsBlocks) {
  ASSERT_EQ(run("export cracked.vtkhdf -o all.csv").code, 0);
  const post::ResultsReader from = results();
  std::map<std::string, int> rows;
  std::map<std::string, std::string> parents;
  for (auto& row : table(slurp(*folder_ / "all.csv"))) {
    ++rows[row["step"]];
    parents[row["block"]] = row["parent"];
  }
  std::map<std::string, int> expected;  // two frames may have the same step
  for (long i = 0; i < from.frames(); ++i)
    expected[std::to_string(from.frame(i).step)] += from.frame(i).count_present();
  EXPECT_EQ(rows, expected);
  for (const post::Crack& crack : from.cracks())
    EXPECT_EQ(parents[std::to_string(crack.child)], std::to_string(crack.parent));
  EXPECT_EQ(parents["1"], "0");
}

// A corner that the block has lost can be asked for: its history ends at the crack.
TEST_F(CrackPictures, HaveHistoriesOfPresentCorners) {
  const post::ResultsReader from = results();
  const post::History history = post::read_history(
      {&from}, {quantities::parse_curve("x:1.3"), quantities::parse_curve("blocks")});
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    const post::Frame now = from.frame(static_cast<long>(i));
    if (now.outlines[0].size() >= 3)
      EXPECT_EQ(history.series[0].values[i], now.outlines[0][2].x());
    else
      EXPECT_TRUE(std::isnan(history.series[0].values[i]));
    EXPECT_EQ(history.series[1].values[i], now.count_present());
  }
}

}  // namespace
}  // namespace blocks::testing
