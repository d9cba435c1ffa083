// Joint ids of sides in results files (PointData/Joint) and in the listing's DUMP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/hdf5_handle.hpp"
#include "output/listing/listing.hpp"
#include "post/read/results_reader.hpp"
#include "sample_model.hpp"

namespace blocks::output {
namespace {

using hdf5::Column;
using post::Frame;
using post::ResultsReader;
using samples::file_error;
using samples::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const RunIdentity identity = {"two.deck", "START\n", "Two blocks", "1.0.0", 1982};

void add_jointed_triangle(Model& model, double x) {
  NewBlock block{{{x, 5}, {x, 6}, {x + 1, 5}}, 4, 1.5};
  block.joints = {7, 0, 2147483647};
  model.blocks.append({block});
}

void write_next(ResultsWriter& writer, Model& model) {
  model.steps += 1;
  model.blocks.corner.array() += 0.25;
  writer.write(model);
}

std::vector<std::int64_t> offsets(const std::string& path) {
  const hdf5::Handle file = hdf5::open_file(path, false);
  Column column = Column::open(file.get(), "VTKHDF/Steps/PointDataOffsets/Joint");
  return column.read<std::int64_t>(0, column.rows());
}

bool has_joint(const std::string& path) {
  const hdf5::Handle file = hdf5::open_file(path, false);
  return hdf5::exists(file.get(), "VTKHDF/PointData/Joint") ||
         hdf5::exists(file.get(), "VTKHDF/Steps/PointDataOffsets");
}

TEST(ResultsJoints, AreAbsentIfAllIdsAreZero) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = samples::two_blocks();
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
  }
  EXPECT_FALSE(has_joint(path));
  EXPECT_THAT(ResultsReader(path).frame(0).joints, IsEmpty());
}

// A removed block has no corners in a frame, so the ids of later blocks move up.
TEST(ResultsJoints, AreWrittenOnceAndReadWithTheirSides) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = samples::two_blocks();
  add_jointed_triangle(model, 4);
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
    write_next(writer, model);
    model.blocks.fixity[0] = Fixity::removed;
    write_next(writer, model);
  }
  EXPECT_THAT(offsets(path), ElementsAre(0, 0, 0));
  const ResultsReader reader(path);
  const std::vector<int> none = {0, 0, 0, 0}, ids = {7, 0, 2147483647};
  EXPECT_THAT(reader.frame(1).joints, ElementsAre(none, none, ids));
  EXPECT_THAT(reader.frame(2).joints, ElementsAre(IsEmpty(), none, ids));
}

// READ9 between motions may add the first joints. Frames before have zeros.
TEST(ResultsJoints, MayBeginInALaterFrameAndAfterAReopening) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = samples::two_blocks(), kept;
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
    write_next(writer, model);
    kept = model;
    add_jointed_triangle(model, 4);
    write_next(writer, model);
    add_jointed_triangle(model, 6);
    write_next(writer, model);
  }
  EXPECT_THAT(offsets(path), ElementsAre(0, 0, 11, 22));
  const std::vector<int> none = {0, 0, 0, 0}, ids = {7, 0, 2147483647};
  EXPECT_THAT(ResultsReader(path).frame(0).joints, ElementsAre(none, none));
  EXPECT_THAT(ResultsReader(path).frame(3).joints, ElementsAre(none, none, ids, ids));
  {
    ResultsWriter writer = ResultsWriter::reopen(path, 3);
    write_next(writer, model);
  }
  EXPECT_THAT(offsets(path), ElementsAre(0, 0, 11, 22));
  EXPECT_THAT(ResultsReader(path).frame(3).joints, ElementsAre(none, none, ids, ids));
  {
    ResultsWriter writer = ResultsWriter::reopen(path, 2);
    write_next(writer, kept);
  }
  EXPECT_THAT(ResultsReader(path).frame(2).joints, ElementsAre(none, none));
}

TEST(ResultsJoints, AreRefusedIfTheyDoNotFitTheFile) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = samples::two_blocks();
  add_jointed_triangle(model, 4);
  const auto refusal = [&](const std::string& dataset, auto value) {
    {
      ResultsWriter writer(path, identity);
      write_next(writer, model);
    }
    {
      const hdf5::Handle file = hdf5::open_file(path, true);
      Column::open(file.get(), "VTKHDF/" + dataset).put(0, &value, 1);
    }
    return file_error([&] { ResultsReader(path).frame(0); });
  };
  EXPECT_THAT(refusal("PointData/Joint", -1), HasSubstr("Joint is negative"));
  EXPECT_THAT(refusal("Steps/PointDataOffsets/Joint", std::int64_t{-1}),
              HasSubstr("PointDataOffsets/Joint is negative"));
  EXPECT_THAT(refusal("Steps/PointDataOffsets/Joint", std::int64_t{5}),
              HasSubstr("cannot read"));
  // A run that continues the file writes the ids of its model.
  {
    ResultsWriter writer = ResultsWriter::reopen(path, 0);
    write_next(writer, model);
  }
  EXPECT_THAT(ResultsReader(path).frame(0).joints[2], ElementsAre(7, 0, 2147483647));
}

// An interrupted frame may leave the dataset without offsets of earlier frames.
TEST(ResultsJoints, OfAnInterruptedFrameAreDropped) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = samples::two_blocks();
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
    write_next(writer, model);
  }
  {
    const hdf5::Handle file = hdf5::open_file(path, true);
    Column(file.get(), "VTKHDF/PointData/Joint", H5T_NATIVE_INT, 0, 256);
    Column(file.get(), "VTKHDF/Steps/PointDataOffsets/Joint", H5T_NATIVE_INT64, 0, 256);
  }
  EXPECT_THAT(ResultsReader(path).frame(1).joints, IsEmpty());
  {
    ResultsWriter writer = ResultsWriter::reopen(path, 2);
    EXPECT_THAT(ResultsReader(path).frame(1).joints, IsEmpty());
    add_jointed_triangle(model, 4);
    write_next(writer, model);
  }
  EXPECT_THAT(offsets(path), ElementsAre(0, 0, 11));
  EXPECT_THAT(ResultsReader(path).frame(2).joints[2], ElementsAre(7, 0, 2147483647));
}

TEST(ListingJoints, AreAColumnOfTheDumpIfThereAreAny) {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  const auto dump = [&] {
    {
      Listing listing(folder / "a.out", false);
      listing.dump(model);
    }
    return samples::contents(folder / "a.out");
  };
  EXPECT_EQ(dump().find("joint"), std::string::npos);
  add_jointed_triangle(model, 4);
  const std::string text = dump();
  EXPECT_THAT(text, HasSubstr("y    joint\n"));
  EXPECT_THAT(text, HasSubstr(" 2147483647\n"));
}

}  // namespace
}  // namespace blocks::output
