#include "output/results/results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cmath>
#include <ctime>
#include <filesystem>
#include <limits>

#include "files/file_access_guard.hpp"
#include "files/file_tools.hpp"
#include "files/hdf5_handle.hpp"
#include "output/checkpoint/checkpoint.hpp"
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

const RunIdentity identity = {"two.deck", "START\n", "Two blocks", "1.0.0", 1982};

/// Moves all blocks a little, so that no frame equals another.
void move_on(Model& model) {
  model.steps += 10;
  model.time += 0.01;
  model.blocks.centroid.array() += 1.0 / 3.0;
  model.blocks.corner.array() += 1.0 / 3.0;
  model.blocks.angle.array() += 0.1;
  model.blocks.velocity.array() -= 0.7;
}

/// Requires that the frame has the state of the model.
void expect_same(const Frame& frame, const Model& model) {
  const Blocks& blocks = model.blocks;
  EXPECT_EQ(frame.time, model.time);
  EXPECT_EQ(frame.step, model.steps);
  EXPECT_EQ(frame.kinetic_energy, totals(model).kinetic_energy);
  ASSERT_EQ(frame.outlines.size(), static_cast<std::size_t>(blocks.size()));
  for (int b = 0; b < blocks.size(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    EXPECT_EQ(frame.outlines[i], blocks.outline(b)) << "block " << b;
    EXPECT_EQ(frame.number[i], b + 1);
    EXPECT_EQ(frame.material[i], blocks.material[i]);
    EXPECT_EQ(frame.fixed[i], static_cast<int>(blocks.fixity[i]));
  }
  EXPECT_EQ(frame.centroid, blocks.centroid);
  EXPECT_EQ(frame.velocity, blocks.velocity);
  EXPECT_EQ(frame.angle, blocks.angle);
  EXPECT_EQ(frame.spin, blocks.spin);
  EXPECT_EQ(frame.stress, blocks.stress);
}

// Blocks may be added between motions. Columns that do not change are stored once.
TEST(Results, AreReadBackExactlyWhileBlocksAreAdded) {
  const TemporaryFolder folder;
  const std::string path = folder / "two.vtkhdf";
  std::vector<Model> states;
  {
    ResultsWriter writer(path, identity);
    Model model = samples::two_blocks();
    for (int i = 0; i < 6; ++i) {
      if (i == 2)
        samples::add_triangle(model, 5, 5);
      if (i == 4)
        model.blocks.fix(1, Fixity::left_domain);
      if (i == 5)
        for (int k = 0; k < 400; ++k)
          samples::add_box(model, k, 20, 0.5, 0.5);
      writer.write(model);
      states.push_back(model);
      move_on(model);
      EXPECT_EQ(ResultsReader(path).frames(),
                i + 1);  // The file is readable during the run.
    }
  }
  const ResultsReader reader(path);
  ASSERT_EQ(reader.frames(), 6);
  EXPECT_EQ(reader.title(), "Two blocks");
  for (long i = 0; i < 6; ++i)
    expect_same(reader.frame(i), states[static_cast<std::size_t>(i)]);
  EXPECT_EQ(reader.nearest(-1.0), 0);
  EXPECT_EQ(reader.nearest(0.0279), 2);
  EXPECT_THROW(reader.frame(6), files::FileError);
}

/// Returns a model with more blocks and corners than are written at a time.
Model many_boxes() {
  Model model = samples::two_blocks();
  std::vector<NewBlock> row;
  for (int k = 0; k < 40000; ++k) {
    const double x = 2.0 * k;
    row.push_back(
        {{{x, 20}, {x, 21 + 0.5 * (k % 3)}, {x + 1, 21}, {x + 1, 20}}, 3, 2.0});
  }
  model.blocks.append(row);
  return model;
}

// A large frame is written in pieces and compared with the frame before in pieces. In
// one frame only the last block has moved.
TEST(Results, AreReadBackExactlyIfAFrameIsWrittenInPieces) {
  const TemporaryFolder folder;
  const std::string path = folder / "many.vtkhdf";
  std::vector<Model> states;
  const auto write = [&](ResultsWriter& writer, Model& model) {
    writer.write(model);
    states.push_back(model);
  };
  Model model = many_boxes();
  const int last = model.blocks.size() - 1;
  {
    ResultsWriter writer(path, identity);
    write(writer, model);
    move_on(model);
    write(writer, model);
    model.steps += 1;
    model.blocks.angle[last] += 1.0;
    model.blocks.stress(2, last) = -4.0;
    model.blocks.fixity[static_cast<std::size_t>(last)] = Fixity::left_domain;
    write(writer, model);
    model.steps += 1;
    samples::add_triangle(model, 5, 5);
    write(writer, model);
    model.steps += 1;
    model.blocks.velocity(1, 0) = 9.0;
    writer.write(model);
  }
  {
    ResultsWriter writer =
        ResultsWriter::reopen(path, 4);  // The last frame is dropped.
    model = states.back();
    model.steps += 1;
    model.blocks.spin[last + 1] = 3.0;
    write(writer, model);
  }
  const ResultsReader reader(path);
  ASSERT_EQ(reader.frames(), 5);
  for (long i = 0; i < 5; ++i)
    expect_same(reader.frame(i), states[static_cast<std::size_t>(i)]);
  const hdf5::Handle file = hdf5::open_file(path, false);
  const auto offsets = [&](const std::string& name) {
    return Column::open(file.get(), "VTKHDF/Steps/CellDataOffsets/" + name)
        .read<std::int64_t>(0, 5);
  };
  const std::int64_t n = last + 1;
  EXPECT_THAT(offsets("Mass"), ElementsAre(0, 0, 0, n, n));
  EXPECT_THAT(offsets("Angle"), ElementsAre(0, n, 2 * n, 3 * n, 3 * n));
  EXPECT_THAT(offsets("Fixed"), ElementsAre(0, 0, n, 2 * n, 2 * n));
}

TEST(Results, HaveEachStepOnce) {
  const TemporaryFolder folder;
  ResultsWriter writer(folder / "a.vtkhdf", identity);
  Model model = samples::two_blocks();
  writer.write(model);
  writer.write(model);
  EXPECT_EQ(writer.frames(), 1);
  move_on(model);
  writer.write(model);
  EXPECT_EQ(writer.frames(), 2);
}

// A restart appends frames after that of its checkpoint.
TEST(Results, DropLaterFramesWhenReopened) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  std::vector<Model> states;
  Model model = samples::two_blocks();
  {
    ResultsWriter writer(path, identity);
    for (int i = 0; i < 4; ++i) {
      if (i == 3)
        samples::add_box(model, 6, 6, 1,
                         1);  // This block is only in a frame that is dropped.
      writer.write(model);
      if (i < 2)
        states.push_back(model);
      move_on(model);
    }
  }
  model = states.back();
  {
    ResultsWriter writer = ResultsWriter::reopen(path, 2);
    EXPECT_EQ(writer.frames(), 2);
    EXPECT_EQ(ResultsReader(path).frames(), 2);
    writer.write(model);  // This is the step of the last frame that was kept.
    EXPECT_EQ(writer.frames(), 2);
    for (int i = 0; i < 2; ++i) {
      move_on(model);
      samples::add_triangle(model, 5, 5 + i);
      writer.write(model);
      states.push_back(model);
    }
  }
  {
    const ResultsReader reader(path);
    ASSERT_EQ(reader.frames(), 4);
    for (long i = 0; i < 4; ++i)
      expect_same(reader.frame(i), states[static_cast<std::size_t>(i)]);
  }
}

TEST(Results, CannotBeReopenedWithMoreFramesThanTheyHave) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  {
    ResultsWriter writer(path, identity);
    Model model = samples::two_blocks();
    for (int i = 0; i < 4; ++i) {
      writer.write(model);
      move_on(model);
    }
  }
  EXPECT_THAT(file_error([&] { ResultsWriter::reopen(path, 5); }),
              HasSubstr("it has 4 frames"));
  EXPECT_EQ(ResultsWriter::reopen(path, 0).frames(), 0);
}

TEST(Results, CannotBeReopenedIfTheFileIsNotHdf5) {
  const TemporaryFolder other;
  samples::overwrite(other / "x.vtkhdf", "not HDF5");
  EXPECT_THAT(file_error([&] { ResultsWriter::reopen(other / "x.vtkhdf", 0); }),
              HasSubstr("x.vtkhdf"));
}

// The reader vtkHDFReader reads the n + 1 cell offsets of a frame at CellOffsets +
// PartOffsets, and its counts at PartOffsets.
TEST(Results, HaveTheLayoutOfVtkhdf) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  {
    ResultsWriter writer(path, identity);
    Model model = samples::two_blocks();
    writer.write(model);
    move_on(model);
    writer.write(model);
    move_on(model);
    samples::add_triangle(model, 5, 5);
    writer.write(model);
  }
  const hdf5::Handle file = hdf5::open_file(path, false);
  const hdf5::Handle vtk = hdf5::open_group(file.get(), "VTKHDF");
  const auto whole = [&](const char* name) {
    Column column = Column::open(vtk.get(), name);
    return column.read<std::int64_t>(0, column.rows());
  };
  EXPECT_EQ(hdf5::read_text_attribute(vtk.get(), "Type"), "UnstructuredGrid");
  EXPECT_THAT(whole("NumberOfPoints"), ElementsAre(8, 11));
  EXPECT_THAT(whole("NumberOfConnectivityIds"), ElementsAre(8, 11));
  EXPECT_THAT(whole("NumberOfCells"), ElementsAre(2, 3));
  EXPECT_THAT(whole("Offsets"), ElementsAre(0, 4, 8, 0, 4, 8, 11));
  EXPECT_THAT(whole("Types"), ElementsAre(7, 7, 7, 7, 7));
  EXPECT_THAT(whole("Steps/NumberOfParts"), ElementsAre(1, 1, 1));
  EXPECT_THAT(whole("Steps/PartOffsets"), ElementsAre(0, 0, 1));
  EXPECT_THAT(whole("Steps/PointOffsets"), ElementsAre(0, 8, 16));
  EXPECT_THAT(whole("Steps/CellOffsets"), ElementsAre(0, 0, 2));
  EXPECT_THAT(whole("Steps/ConnectivityIdOffsets"), ElementsAre(0, 0, 8));
  EXPECT_THAT(whole("Steps/CellDataOffsets/Mass"), ElementsAre(0, 0, 2));
  EXPECT_THAT(whole("Steps/CellDataOffsets/Centroid"), ElementsAre(0, 2, 4));
  EXPECT_THAT(whole("Steps/FieldDataOffsets/Time"), ElementsAre(0, 1, 2));
  EXPECT_THAT(whole("Steps/FieldDataSizes/Time"), ElementsAre(1, 1, 1, 1, 1, 1));
  EXPECT_EQ(Column::open(vtk.get(), "Points").width(), 3U);
  EXPECT_EQ(Column::open(vtk.get(), "CellData/Force").width(), 3U);
  EXPECT_EQ(Column::open(vtk.get(), "CellData/StrainRate").width(), 4U);
}

// The normal points out of the block that owns the edge, here upwards.
TEST(Results, HaveTheActiveContacts) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = samples::two_blocks();
  {
    ResultsWriter writer(path, identity);
    writer.write(model);
    move_on(model);
    model.plane_contacts[0].active = true;
    model.plane_contacts[0].normal_force = 2.5;
    writer.write(model);
  }
  const hdf5::Handle file = hdf5::open_file(path, false);
  const hdf5::Handle group = hdf5::open_group(file.get(), "BLOCKS/contacts");
  const auto whole = [&](const char* name) {
    Column column = Column::open(group.get(), name);
    return column.read<std::int64_t>(0, column.rows());
  };
  const auto real = [&](const char* name) {
    Column column = Column::open(group.get(), name);
    return column.read<double>(0, column.rows());
  };
  EXPECT_THAT(whole("Offsets"), ElementsAre(0, 1));
  EXPECT_THAT(whole("Counts"), ElementsAre(1, 2));
  EXPECT_THAT(whole("CornerBlock"), ElementsAre(2, 2, 1));
  EXPECT_THAT(whole("Corner"), ElementsAre(1, 1, 1));
  EXPECT_THAT(whole("EdgeBlock"), ElementsAre(1, 1, 0));
  EXPECT_THAT(whole("Edge"), ElementsAre(2, 2, 1));
  EXPECT_THAT(real("Normal"), ElementsAre(0, 1, 0, 0, 1, 0, 1, 0, 0));
  EXPECT_THAT(real("NormalForce"), ElementsAre(0.75, 0.75, 2.5));
  EXPECT_THAT(real("ShearForce"), ElementsAre(-0.125, -0.125, 0));
  EXPECT_THAT(real("Overlap"), ElementsAre(0.0625, 0.0625, 0));
}

TEST(Results, KeepAnOlderFileAsBak) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  samples::overwrite(path, "older");
  samples::overwrite(path + ".bak", "oldest");
  {
    const ResultsWriter writer(path, identity);
    EXPECT_EQ(samples::contents(path), "older") << "until there is a first frame";
  }
  EXPECT_FALSE(std::filesystem::exists(path + ".tmp"));
  ResultsWriter(path, identity).write(samples::two_blocks());
  EXPECT_EQ(samples::contents(path + ".bak"), "oldest");
  EXPECT_EQ(samples::contents(path + ".bak2"), "older");
  EXPECT_EQ(ResultsReader(path).frames(), 1);
}

// A device that is replaced by a file is lost for the whole machine. The test uses a
// fifo in place of a device.
TEST(Results, ReplaceNothingButRegularFiles) {
  const TemporaryFolder folder;
  const std::string fifo = folder / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const std::string expected =
      "cannot write " + fifo + ": it is not a regular file; choose another name";
  EXPECT_EQ(file_error([&] { ResultsWriter(fifo, identity); }), expected);
  EXPECT_EQ(file_error([&] { write_checkpoint(fifo, Model{}, {}); }), expected);
  EXPECT_EQ(file_error([&] { files::move_file(fifo, fifo + ".bak"); }), expected);
  EXPECT_TRUE(std::filesystem::is_fifo(fifo));
  EXPECT_FALSE(std::filesystem::exists(fifo + ".tmp"));
}

TEST(Results, KeepValuesThatAreNotFinite) {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  model.blocks.velocity(0, 1) = std::numeric_limits<double>::quiet_NaN();
  model.blocks.corner(1, 5) = -std::numeric_limits<double>::infinity();
  ResultsWriter(folder / "a.vtkhdf", identity).write(model);
  const Frame frame = ResultsReader(folder / "a.vtkhdf").frame(0);
  EXPECT_TRUE(std::isnan(frame.velocity(0, 1)));
  EXPECT_EQ(frame.outlines[1][1].y(), -std::numeric_limits<double>::infinity());
}

TEST(Results, ErrorsNameTheFileAndTheReason) {
  const TemporaryFolder folder;
  EXPECT_THAT(file_error([&] { ResultsWriter(folder / "no/a.vtkhdf", identity); }),
              testing::AllOf(HasSubstr("cannot write"), HasSubstr("no/a.vtkhdf"),
                             HasSubstr("No such file or directory")));
  const std::string path = folder / "a.vtkhdf";
  const auto error = [&] { return file_error([&] { ResultsReader reader(path); }); };
  EXPECT_THAT(error(), testing::AllOf(HasSubstr(path), HasSubstr("No such file")));
  samples::overwrite(path, "text");
  EXPECT_THAT(error(), HasSubstr(path));
  hdf5::create_file(path).close();
  EXPECT_THAT(error(), HasSubstr("not a results file"));
}

// HDF5 1.10 does not finish closing a file whose chunks have a wrong number of rows. A
// mutant of fuzz_results had such chunks.
TEST(Results, ReportATruncatedFile) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  {
    ResultsWriter writer(path, identity);
    writer.write(samples::two_blocks());
  }
  const auto whole = std::filesystem::file_size(path);
  const auto error = [&](std::uintmax_t bytes) {
    std::filesystem::resize_file(path, bytes);
    return file_error([&] { ResultsReader reader(path); });
  };
  const std::string begin = "cannot read " + path + ": it is truncated, it has ";
  for (const auto bytes : {whole - 1, whole / 2, std::uintmax_t{600}})
    EXPECT_THAT(error(bytes), HasSubstr(begin + std::to_string(bytes) + " of " +
                                        std::to_string(whole) +
                                        " bytes; copy it again or repeat the run"));
  for (const std::uintmax_t bytes : {512, 100})
    EXPECT_THAT(error(bytes),
                HasSubstr(begin + "no data; copy it again or repeat the run"));
}

TEST(Results, ReportAFileThatHdf5CannotClose) {
  const auto close = [] {
    const std::string path = "a.vtkhdf";
    files::FileAccessGuard in_hand("continue", path);
    in_hand.must_end_within(1);
    // The loop never ends. The thread sanitizer delivers signals at calls only.
    while (std::time(nullptr) != 0) {
    }
  };
  EXPECT_EXIT(
      close(), testing::ExitedWithCode(5),
      "^blocks: error: cannot continue a.vtkhdf: it is damaged, HDF5 failed on it\n$");
}

}  // namespace
}  // namespace blocks::output
