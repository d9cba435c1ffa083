#include "output/checkpoint/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "output/checkpoint/model_archive.hpp"
#include "sample_model.hpp"
#include "tools/fields.hpp"

namespace blocks::output {
namespace {

using samples::contents;
using samples::fields;
using samples::file_error;
using samples::overwrite;
using samples::TemporaryFolder;
using ::testing::HasSubstr;

/// Sets every field to a different value, including special doubles.
class Filler {
 public:
  template <class T> void operator()(const Field& field, T& value) {
    fill(field.name, value);
  }
  template <class R, class Visit>
  void records(const Field& field, std::vector<R>& list, Visit&& visit) {
    list.resize(3);
    auto member = [&](const Field& at, auto& value) {
      fill(std::string(field.name) + at.name, value);
    };
    for (R& record : list)
      visit(member, record);
  }
  template <class Map, class Visit>
  void materials(const Field& field, Map& map, Visit&& visit) {
    auto member = [&](const Field& at, auto& value) {
      fill(std::string(field.name) + at.name, value);
    };
    for (int i = 0; i < 3; ++i) {
      typename Map::key_type number{};
      typename Map::mapped_type material;
      visit(member, number, material);
      map.emplace(number, material);
    }
  }

 private:
  template <Number T> void fill(const std::string&, T& value) {
    if constexpr (std::is_same_v<T, bool>)
      value = true;
    else if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(++count_ % 4);
    else if constexpr (std::is_same_v<T, double>)
      value = next();
    else if constexpr (std::is_same_v<T, char>)
      value = static_cast<char>(++count_ % 2);
    else
      value = static_cast<T>(1000 + ++count_);
  }
  void fill(const std::string& name, std::string& text) {
    text = "text of " + name + " \xC3\xA9\t";
  }
  void fill(const std::string&, geometry::Decimal& number) {
    number = *geometry::Decimal::parse("-12." + std::to_string(++count_) + "1e-3");
  }
  template <class T> void fill(const std::string& name, std::optional<T>& value) {
    fill(name, value.emplace());
  }
  template <class T> void fill(const std::string& name, std::vector<T>& values) {
    values.resize(5);
    for (auto&& place : values) {
      T value = place;
      fill(name, value);
      place = value;
    }
  }
  template <class D> void fill(const std::string&, Eigen::PlainObjectBase<D>& m) {
    if constexpr (D::SizeAtCompileTime == Eigen::Dynamic)
      m.resize(D::RowsAtCompileTime == Eigen::Dynamic ? 7 : D::RowsAtCompileTime,
               D::ColsAtCompileTime == Eigen::Dynamic ? 7 : D::ColsAtCompileTime);
    for (Eigen::Index i = 0; i < m.size(); ++i)
      m.data()[i] = next();
  }
  double next() {
    constexpr double awkward[] = {-0.0, std::numeric_limits<double>::denorm_min(),
                                  std::numeric_limits<double>::quiet_NaN(),
                                  -std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::max()};
    ++count_;
    return count_ % 4 == 0 ? awkward[count_ / 4 % 5] : -1.0 / (3.0 + count_);
  }
  int count_ = 0;
};

Model filled_model() {
  Model model;
  Filler filler;
  visit_model(model, filler);
  model.settings.seed = 0xFFFFFFFFFFFFFFFFULL;  // No signed number holds this seed.
  return model;
}

const CheckpointInfo info = {
    .deck_file = "crater.deck",
    .deck_text = "START\n",
    .overrides = "MOTION.dt=1\n",
    .results = "crater.vtkhdf",
    .results_run = "0a1b2c3d",
    .results_frames = 12,
    .listing_bytes = 4096,
    .version = "1.0.0",
    .progress = {.card = 7,
                 .steps_left = 31,
                 .below_ratio = true,
                 .frames = 11,
                 .samples = 77,
                 .listing_bytes = 4000,
                 .tabled_step = 250,
                 .half_depth = 0.25,
                 .fast_reported = true,
                 .flight_reported = true,
                 .deep_reported = true,
                 .finished = true,
                 .warnings = "one\ntwo\n",
                 .overlaps = {{0, 1, 0.125, {0.25, 0.5}, 0.75}}}};

/// Writes the fields of a model, reads them and requires the same values.
void expect_kept(const Model& model) {
  const TemporaryFolder folder;
  const auto written = fields(model);
  const hdf5::Handle file = hdf5::create_file(folder / "fields.h5");
  SavingArchive saving(file.get());
  visit_model(model, saving);
  Model read;
  LoadingArchive loading(file.get());
  visit_model(read, loading);
  const auto back = fields(read);
  ASSERT_EQ(back.size(), written.size());
  for (const auto& [name, value] : written)
    EXPECT_EQ(back.at(name), value) << name;
}

// Continued runs have the same bits only if all fields have the same bits.
TEST(Checkpoint, KeepsTheBitsOfEveryField) {
  const Model model = filled_model();
  const auto written = fields(model), untouched = fields(Model());
  for (const auto& [name, value] : written) {
    EXPECT_NE(value, untouched.contains(name) ? untouched.at(name) : "") << name;
  }
  expect_kept(model);
}

// Long lists are written in pieces.
TEST(Checkpoint, KeepsTheBitsOfLongLists) {
  Model model = filled_model();
  for (int i = 0; i < 200000; ++i)
    model.contacts.push_back(
        {i % 7, -i, 0.1 * i, -0.3 * i, 1.0 / (i + 1), 7.0 + i, 1e-9 * i});
  expect_kept(model);
}

TEST(Checkpoint, KeepsModelAndRun) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.ckpt.h5";
  const Model model = samples::two_blocks();
  write_checkpoint(path, model, info);
  CheckpointInfo read;
  EXPECT_EQ(fields(read_checkpoint(path, read)), fields(model));
  EXPECT_EQ(read.deck_file, info.deck_file);
  EXPECT_EQ(read.deck_text, info.deck_text);
  EXPECT_EQ(read.overrides, info.overrides);
  EXPECT_EQ(read.results, info.results);
  EXPECT_EQ(read.results_run, info.results_run);
  EXPECT_EQ(read.results_frames, info.results_frames);
  EXPECT_EQ(read.listing_bytes, info.listing_bytes);
  EXPECT_EQ(read.version, info.version);
  EXPECT_EQ(read.progress.card, info.progress.card);
  EXPECT_EQ(read.progress.steps_left, info.progress.steps_left);
  EXPECT_EQ(read.progress.below_ratio, info.progress.below_ratio);
  EXPECT_EQ(read.progress.frames, info.progress.frames);
  EXPECT_EQ(read.progress.samples, info.progress.samples);
  EXPECT_EQ(read.progress.listing_bytes, info.progress.listing_bytes);
  EXPECT_EQ(read.progress.tabled_step, info.progress.tabled_step);
  EXPECT_EQ(read.progress.half_depth, info.progress.half_depth);
  EXPECT_EQ(read.progress.fast_reported, info.progress.fast_reported);
  EXPECT_EQ(read.progress.flight_reported, info.progress.flight_reported);
  EXPECT_EQ(read.progress.deep_reported, info.progress.deep_reported);
  EXPECT_EQ(read.progress.finished, info.progress.finished);
  EXPECT_EQ(read.progress.warnings, info.progress.warnings);
  ASSERT_EQ(read.progress.overlaps.size(), 1U);
  EXPECT_EQ(read.progress.overlaps[0].second, 1);
  EXPECT_EQ(read.progress.overlaps[0].place, Vec2(0.25, 0.5));
}

// A deck that stops before its first block has empty arrays.
TEST(Checkpoint, KeepsAModelWithoutBlocks) {
  const TemporaryFolder folder;
  const Model model = samples::no_blocks();
  write_checkpoint(folder / "a.ckpt.h5", model, {});
  CheckpointInfo read;
  EXPECT_EQ(fields(read_checkpoint(folder / "a.ckpt.h5", read)), fields(model));
}

TEST(Checkpoint, RefusesAnyDamagedByte) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.ckpt.h5";
  write_checkpoint(path, samples::two_blocks(), info);
  const std::string sound = contents(path);
  CheckpointInfo read;
  long bytes_tried = 0;
  for (std::size_t at = 0; at < sound.size(); at = at < 600 ? at + 1 : at + 4099) {
    ++bytes_tried;
    std::string bytes = sound;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    overwrite(path, bytes);
    EXPECT_THAT(file_error([&] { read_checkpoint(path, read); }), HasSubstr(path))
        << "byte " << at;
  }
  RecordProperty("bytes", std::to_string(bytes_tried));
}

TEST(Checkpoint, RefusesATruncatedFile) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.ckpt.h5";
  write_checkpoint(path, samples::two_blocks(), info);
  const std::string sound = contents(path);
  CheckpointInfo read;
  for (const std::size_t bytes : {600UL, sound.size() / 2, sound.size() - 1}) {
    overwrite(path, sound.substr(0, bytes));
    EXPECT_EQ(file_error([&] { read_checkpoint(path, read); }),
              "cannot read " + path + ": it is truncated, it has " +
                  std::to_string(bytes) + " of " + std::to_string(sound.size()) +
                  " bytes; copy it again or repeat the run");
  }
  overwrite(path, sound.substr(0, 100));  // less than the seal
  EXPECT_THAT(file_error([&] { read_checkpoint(path, read); }),
              HasSubstr("it is truncated, it has 100 of "));
}

TEST(Checkpoint, SaysWhyItIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.ckpt.h5";
  CheckpointInfo read;
  const auto error = [&] { return file_error([&] { read_checkpoint(path, read); }); };
  EXPECT_THAT(error(), HasSubstr("No such file"));
  overwrite(path, "START\n");
  EXPECT_THAT(error(), HasSubstr("not a checkpoint of BLOCKS"));
  write_checkpoint(path, samples::two_blocks(), info);
  const std::string bytes = contents(path);
  const auto written_by = [&](const std::string& format) {
    std::string other = bytes;
    other.replace(bytes.find("format ") + 7, 2, format);
    overwrite(path, other);
    return error();
  };
  EXPECT_THAT(written_by("99"), HasSubstr("newer version"));
  EXPECT_THAT(written_by("09"), HasSubstr("older version"));
}

TEST(Checkpoint, KeepsThePreviousCheckpoint) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.ckpt.h5";
  Model model = samples::two_blocks();
  for (const long steps : {1L, 2L, 3L}) {
    model.steps = steps;
    model.time = static_cast<double>(steps) * model.time_step.dt;
    write_checkpoint(path, model, info);
  }
  CheckpointInfo read;
  EXPECT_EQ(read_checkpoint(path, read).steps, 3);
  EXPECT_EQ(read_checkpoint(path + ".prev", read).steps, 2);
  EXPECT_FALSE(std::filesystem::exists(path + ".tmp"));
  std::filesystem::remove(path);
  EXPECT_THAT(file_error([&] { read_checkpoint(path, read); }), HasSubstr(".prev"));
}

TEST(Checkpoint, CannotBeWrittenIntoAMissingFolder) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      file_error([&] { write_checkpoint(folder / "no/a.ckpt.h5", Model(), info); }),
      testing::AllOf(HasSubstr("cannot write"),
                     HasSubstr("No such file or directory")));
}

}  // namespace
}  // namespace blocks::output
