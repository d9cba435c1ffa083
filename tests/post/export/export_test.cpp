// `blocks export` of many times.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <map>
#include <sstream>

#include "post/read/frame_quantity.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

class ExportTimes : public ::testing::Test {
 protected:
  void SetUp() override {
    run_text(
        folder_, "fall",
        preliminary() + rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
            "GRAVITY, 1, -10\nPLOTS, 0.01\nHISTORY, 0.01, unbalanced:2\nCYCLE, 100\n");
  }
  Outcome run(const std::string& arguments) const {
    return blocks("export fall.vtkhdf " + arguments, folder_.path());
  }
  /// Returns the rows of a CSV file, with numbers by the name of the column.
  std::vector<std::map<std::string, double>> table(const std::string& name) const {
    std::istringstream lines(slurp(folder_ / name));
    std::string line, field;
    std::getline(lines, line);
    std::vector<std::string> names;
    for (std::istringstream head(line); std::getline(head, field, ',');)
      names.push_back(field);
    std::vector<std::map<std::string, double>> rows;
    while (std::getline(lines, line)) {
      rows.emplace_back();
      std::istringstream fields(line);
      for (const std::string& column : names) {
        std::getline(fields, field, ',');
        rows.back()[column] = std::stod(field);
      }
    }
    return rows;
  }
  TemporaryFolder folder_;
};

TEST_F(ExportTimes, WritesTheBitsOfAllNumbersToCsv) {
  ASSERT_EQ(run("-o all.csv").code, 0);
  const auto rows = table("all.csv"), contacts = table("all_contacts.csv");
  const post::ResultsReader results((folder_ / "fall.vtkhdf").string());
  const post::Frame first = results.frame(0);
  std::size_t row = 0, acting_row = 0;
  for (long i = 0; i < results.frames(); ++i) {
    const post::Frame now = results.frame(i);
    for (const auto& kind : quantities::quantity_kinds()) {
      const Eigen::VectorXd values = post::values_of(kind, now, first);
      for (int b = 0; b < now.size(); ++b)
        EXPECT_EQ(rows.at(row + static_cast<std::size_t>(b)).at(kind.name), values[b])
            << kind.name;
    }
    row += static_cast<std::size_t>(now.size());
    const post::FrameContacts acting = results.contacts(i);
    for (int c = 0; c < acting.size(); ++c, ++acting_row) {
      EXPECT_EQ(contacts.at(acting_row).at("normal_force"), acting.normal_force[c]);
      EXPECT_EQ(contacts.at(acting_row).at("x"), acting.point(0, c));
    }
  }
  EXPECT_EQ(rows.size(), row);
  EXPECT_EQ(contacts.size(), acting_row);
  EXPECT_GT(acting_row, 3U) << "nothing touched";
}

TEST_F(ExportTimes, KeepsOneOlderVersionOfItsFiles) {
  for (const char* name : {"a.pvd", "a_contacts.pvd"})
    folder_.write(name, "mine");
  for (int i = 0; i < 3; ++i)
    ASSERT_EQ(run("-o a.pvd").code, 0);
  for (const char* name : {"a.pvd", "a.pvd.bak", "a_contacts.pvd.bak",
                           "a_vtu/blocks_0.vtu", "a_vtu.bak/contacts_0.vtu"})
    EXPECT_TRUE(folder_.holds(name)) << name;
}

TEST_F(ExportTimes, DoesNotReplaceAFolderWithForeignFiles) {
  for (int i = 0; i < 2; ++i)
    ASSERT_EQ(run("-o a.pvd").code, 0);
  folder_.write("a_vtu.bak/mine.txt", "precious");
  folder_.write("a_vtu.bak/blocks_mine.vtu", "precious");
  const Outcome refused = run("-o a.pvd");
  EXPECT_EQ(refused.code, 5);
  EXPECT_THAT(refused.err, HasSubstr("a_vtu.bak contains other files"));
  EXPECT_EQ(slurp(folder_ / "a_vtu.bak/mine.txt"), "precious");
  EXPECT_EQ(slurp(folder_ / "a_vtu.bak/blocks_mine.vtu"), "precious");
  EXPECT_TRUE(folder_.holds("a_vtu/blocks_0.vtu"));
}

// A folder without its .pvd file, and the lock, were left behind.
TEST_F(ExportTimes, LeavesNothingAfterAnInterrupt) {
  run_text(folder_, "long",
           preliminary() + rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
               "GRAVITY, 1, -10\nPLOTS, 0.0004\nCYCLE, 2000\n");
  ASSERT_EQ(run("-o a.pvd").code, 0);
  const std::string before = slurp(folder_ / "a_vtu/blocks_0.vtu");
  EXPECT_EQ(
      killed("export long.vtkhdf -o a.pvd", "a_vtu.tmp", 0.0, SIGINT, folder_.path()),
      130)
      << "the export was over before it could be interrupted";
  for (const char* name : {"a_vtu.tmp", "a_vtu.lock", "a_vtu.bak", "a.pvd.bak"})
    EXPECT_FALSE(folder_.holds(name)) << name;
  EXPECT_EQ(slurp(folder_ / "a_vtu/blocks_0.vtu"), before);
  // What a killed program leaves does not hinder the next one.
  EXPECT_EQ(
      killed("export long.vtkhdf -o a.pvd", "a_vtu.tmp", 0.0, SIGKILL, folder_.path()),
      -1);
  EXPECT_TRUE(folder_.holds("a_vtu.tmp"));
  EXPECT_EQ(run("-o a.pvd").code, 0);
  EXPECT_FALSE(folder_.holds("a_vtu.tmp"));
}

TEST_F(ExportTimes, NamesTheChoicesIfAnOptionIsWrong) {
  EXPECT_THAT(run("-o a.xyz").err, HasSubstr(".txt, .pvd or .csv"));
  EXPECT_THAT(run("-o a.csv -t 7").err, HasSubstr("fall.vtkhdf has times 0 to 0.04"));
  EXPECT_EQ(run("-o none/a.csv").code, 5);
}

TEST_F(ExportTimes, RefusesFilesThatAreNoResults) {
  const Outcome deck = blocks("export fall.deck -o a.pvd", folder_.path());
  EXPECT_EQ(deck.code, 2);
  EXPECT_THAT(deck.err, HasSubstr("first run the deck with blocks run fall.deck"));
  const Outcome listing = blocks("export fall.out", folder_.path());
  EXPECT_EQ(listing.code, 5);
  EXPECT_THAT(listing.err,
              HasSubstr("fall.out is a listing; export reads results and decks\n  "
                        "hint: results in this folder: fall.vtkhdf"));
  folder_.write("fall.bin", std::string("\x7f\0\1", 3));
  const Outcome foreign = blocks("export fall.bin", folder_.path());
  EXPECT_EQ(foreign.code, 5);
  EXPECT_THAT(foreign.err, HasSubstr("neither a deck nor results of BLOCKS"));
}

}  // namespace
}  // namespace blocks::testing
