// The states of the laws of joints in results files (BLOCKS/contacts) and in the
// listing's DUMP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/hdf5_handle.hpp"
#include "output/listing/listing.hpp"
#include "post/read/results_reader.hpp"
#include "sample_model.hpp"

namespace blocks::output {
namespace {

using post::ResultsReader;
using samples::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const RunIdentity identity = {"two.deck", "START\n", "Two blocks", "1.0.0", 1982};

/// A contact with a law, one without, and one with a plane.
Model with_states() {
  Model model = samples::two_blocks();
  model.contacts.push_back({7, 1, 0.25, 0.0, 0.25, 0.0, 0.03125});
  model.plane_contacts[0].active = true;
  model.settings.joint_laws[5] = {};
  LawState state;
  state.law = 5, state.bonded = true, state.failed = true;
  state.slip = -0.5, state.path = 0.75, state.offset = 0.125;
  state.closure = 0.0625, state.plastic = 0.03125;
  state.stiffness = 1e6, state.shear_stiffness = 5e5, state.length = 2.0;
  LawState without_law;  // its slip is of no interest
  without_law.slip = 7.0, without_law.failed = true;
  model.law_states = {state, without_law};
  return model;
}

void write_next(ResultsWriter& writer, Model& model) {
  model.steps += 1;
  writer.write(model);
}

bool has(const std::string& path, const char* name) {
  const hdf5::Handle file = hdf5::open_file(path, false);
  return hdf5::exists(file.get(), std::string("BLOCKS/contacts/") + name);
}

TEST(ResultsJointStates, AreAbsentWithoutLaws) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = samples::two_blocks();
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
  }
  for (const char* name : {"Law", "Bonded", "Slip", "Length"})
    EXPECT_FALSE(has(path, name)) << name;
  EXPECT_TRUE(ResultsReader(path).contacts(0).states.empty());
}

// The frame before the first JOINT card and the contacts with planes have zeros.
TEST(ResultsJointStates, AreReadBackFromTheFrameInWhichTheyBegin) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  {
    ResultsWriter writer(path, identity);
    Model model = with_states();
    const Model laws = model;
    model.settings.joint_laws.clear();
    model.law_states.clear();
    write_next(writer, model);
    model.settings.joint_laws = laws.settings.joint_laws;
    model.law_states = laws.law_states;
    write_next(writer, model);
  }
  const ResultsReader results(path);
  const LawState none, with_law = with_states().law_states[0];
  EXPECT_THAT(results.contacts(0).states, ElementsAre(none, none, none));
  EXPECT_THAT(results.contacts(1).states, ElementsAre(with_law, none, none));
}

TEST(ResultsJointStates, AContinuedFileIsThatOfARunThatWasNotInterrupted) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = with_states();
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
    model.law_states[0].slip = 99.0;
    write_next(writer, model);
  }
  {
    ResultsWriter writer = ResultsWriter::reopen(path, 1);
    model.contacts.pop_back(), model.law_states.pop_back();
    model.law_states[0].slip = 3.0;
    write_next(writer, model);
  }
  const ResultsReader results(path);
  EXPECT_EQ(results.contacts(0).states[0].slip, -0.5);
  EXPECT_EQ(results.contacts(1).states[0].slip, 3.0);
}

TEST(ResultsJointStates, AreConvertedWithTheUnits) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = with_states();
  model.settings.units = {"m", "kg", "s"};
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
  }
  ResultsReader results(path);
  results.show_in({"mm", "kg", "s"});
  EXPECT_EQ(results.contacts(0).states[0].slip, -500.0);
  EXPECT_EQ(results.contacts(0).states[0].length, 2000.0);
  EXPECT_EQ(results.contacts(0).states[0].stiffness, 1e3) << "kg/(mm s^2)";
}

TEST(ListingJointStates, DumpListsTheContactsWithALaw) {
  const TemporaryFolder folder;
  const auto dumped = [&](const Model& model) {
    Listing listing(folder / "a.out", false);
    listing.dump(model);
    return samples::contents(folder / "a.out");
  };
  EXPECT_THAT(dumped(samples::two_blocks()), Not(HasSubstr("JOINTS")));
  const std::string text = dumped(with_states());
  const auto begin = text.find("CONTACTS OF JOINTS WITH A LAW");
  ASSERT_NE(begin, std::string::npos);
  const std::string table = text.substr(begin, text.find("\n\n", begin) - begin);
  EXPECT_THAT(table, HasSubstr("        5 weakened             -0.5            0.125"
                               "          0.03125                2"));
  EXPECT_THAT(table, Not(HasSubstr("intact")));
}

}  // namespace
}  // namespace blocks::output
