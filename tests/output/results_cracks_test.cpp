// The record of cracks in results files (BLOCKS/cracks, CellData/Parent), in the
// summary and in the listing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "files/hdf5_handle.hpp"
#include "output/listing/listing.hpp"
#include "output/summary.hpp"
#include "post/read/results_reader.hpp"
#include "sample_model.hpp"

namespace blocks::output {
namespace {

using hdf5::Column;
using nlohmann::json;
using post::Crack;
using post::ResultsReader;
using samples::file_error;
using samples::TemporaryFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const RunIdentity identity = {"two.deck", "START\n", "Two blocks", "1.0.0", 1982};

/// Records that block 2 has split, and adds the block that split off.
void crack(Model& model, CrackCause cause = CrackCause::stress) {
  CrackRecord record = samples::crack_of_block_2();
  record.step = model.steps;
  record.child = model.blocks.size();
  record.cause = cause;
  model.cracks.push_back(record);
  samples::add_triangle(model, 4.0 + model.blocks.size(), 5);
}

Model crackable() {
  Model model = samples::two_blocks();
  model.settings.crack_rules[3] = {1e6, 0.25, 5e5, 7};
  return model;
}

void write_next(ResultsWriter& writer, Model& model) {
  model.steps += 1;
  writer.write(model);
}

bool has_record(const std::string& path) {
  const hdf5::Handle file = hdf5::open_file(path, false);
  return hdf5::exists(file.get(), "BLOCKS/cracks") ||
         hdf5::exists(file.get(), "VTKHDF/CellData/Parent") ||
         hdf5::exists(file.get(), "VTKHDF/Steps/CellDataOffsets/Parent");
}

TEST(ResultsCracks, AreAbsentWithoutACrackCard) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = samples::two_blocks();
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
  }
  EXPECT_FALSE(has_record(path));
  const ResultsReader results(path);
  EXPECT_THAT(results.cracks(), IsEmpty());
  EXPECT_EQ(results.frame(0).cracks, 0);
  EXPECT_THAT(results.frame(0).parent, IsEmpty());
}

TEST(ResultsCracks, AreReadBackWithAllValues) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = crackable();
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
    crack(model, CrackCause::point_loads);
    write_next(writer, model);
  }
  const ResultsReader results(path);
  ASSERT_EQ(results.cracks().size(), 1U);
  const Crack read = results.cracks()[0];
  const CrackRecord& made = model.cracks[0];
  EXPECT_EQ(read.step, made.step);
  EXPECT_EQ(read.time, made.time);
  EXPECT_EQ(read.parent, 2);
  EXPECT_EQ(read.child, 3);
  EXPECT_TRUE(read.by_points);
  EXPECT_EQ(read.stress, made.stress);
  EXPECT_EQ(read.from, made.from);
  EXPECT_EQ(read.to, made.to);
  EXPECT_EQ(read.moved, made.moved);
  EXPECT_EQ(read.parent_area, made.parent_area);
  EXPECT_EQ(read.child_area, made.child_area);
  EXPECT_EQ(read.kinetic_before, made.kinetic_before);
  EXPECT_EQ(read.kinetic_after, made.kinetic_after);
  EXPECT_EQ(read.strain_before, made.strain_before);
  EXPECT_EQ(read.strain_after, made.strain_after);
  EXPECT_EQ(read.length(), 5.0);
  EXPECT_NEAR(read.angle(), 126.8698976458, 1e-9);  // 3-4-5, down to the right
  EXPECT_EQ(read.angle(), made.angle());
  EXPECT_EQ(read.released(), made.released());
  EXPECT_EQ(results.frame(0).cracks, 0);
  EXPECT_EQ(results.frame(1).cracks, 1);
  EXPECT_THAT(results.frame(0).parent, ElementsAre(0, 0));
  EXPECT_THAT(results.frame(1).parent, ElementsAre(0, 0, 2));
}

// The CRACK card may follow the first motion.
TEST(ResultsCracks, MayBeginInALaterFrame) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = samples::two_blocks();
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
    write_next(writer, model);
    model.settings.crack_rules = crackable().settings.crack_rules;
    crack(model);
    crack(model);
    write_next(writer, model);
  }
  const ResultsReader results(path);
  EXPECT_EQ(results.cracks().size(), 2U);
  EXPECT_EQ(results.frame(1).cracks, 0);
  EXPECT_EQ(results.frame(2).cracks, 2);
  EXPECT_THAT(results.frame(0).parent, ElementsAre(0, 0));
  EXPECT_THAT(results.frame(2).parent, ElementsAre(0, 0, 2, 2));
}

TEST(ResultsCracks, AreCutBackWithTheFramesAtARestart) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = crackable();
  std::vector<Model> states;
  {
    ResultsWriter writer(path, identity);
    for (int i = 0; i < 4; ++i) {
      write_next(writer, model);
      states.push_back(model);
      crack(model);
    }
  }
  ASSERT_EQ(ResultsReader(path).cracks().size(), 3U);
  const auto steps = [&] {
    std::vector<long> all;
    for (const Crack& one : ResultsReader(path).cracks())
      all.push_back(one.step);
    return all;
  };
  model = states[1];  // one crack
  {
    ResultsWriter writer = ResultsWriter::reopen(path, 2);
    EXPECT_THAT(steps(), ElementsAre(states[1].cracks[0].step));
    model.steps += 100;
    crack(model);
    write_next(writer, model);
  }
  EXPECT_THAT(steps(), ElementsAre(model.cracks[0].step, model.cracks[1].step));
  EXPECT_EQ(ResultsReader(path).frame(2).cracks, 2);
  EXPECT_THAT(ResultsReader(path).frame(2).parent, ElementsAre(0, 0, 2, 2));
  model = crackable();
  {
    ResultsWriter writer = ResultsWriter::reopen(path, 0);
    crack(model);
    write_next(writer, model);
  }
  EXPECT_THAT(steps(), ElementsAre(model.cracks[0].step));
}

TEST(ResultsCracks, AreConvertedWithTheUnits) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  Model model = crackable();
  model.settings.units = {"m", "kg", "s"};
  crack(model);
  {
    ResultsWriter writer(path, identity);
    write_next(writer, model);
  }
  ResultsReader results(path);
  results.show_in({"mm", "g", "ms"});
  const Crack read = results.cracks()[0];
  const CrackRecord& made = model.cracks[0];
  EXPECT_DOUBLE_EQ(read.time, 1e3 * made.time);
  EXPECT_DOUBLE_EQ(read.length(), 1e3 * made.length());
  EXPECT_DOUBLE_EQ(read.moved, 1e3 * made.moved);
  EXPECT_DOUBLE_EQ(read.parent_area, 1e6 * made.parent_area);
  EXPECT_DOUBLE_EQ(read.stress, 1e-6 * made.stress);         // g mm^-1 ms^-2 = 1e6 Pa
  EXPECT_DOUBLE_EQ(read.released(), 1.0 * made.released());  // g mm ms^-2 = N
  EXPECT_EQ(read.angle(), made.angle());
}

// The counts are made last; without them no frame has the record.
TEST(ResultsCracks, OfAnInterruptedFrameAreDropped) {
  for (const bool counted : {false, true}) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.vtkhdf";
    Model model = samples::two_blocks();
    {
      ResultsWriter writer(path, identity);
      write_next(writer, model);
    }
    {
      Model later = crackable();
      later.steps = model.steps;
      ResultsWriter writer = ResultsWriter::reopen(path, 1);
      write_next(writer, later);
    }
    {
      const hdf5::Handle file = hdf5::open_file(path, true);
      const hdf5::Handle steps = hdf5::open_group(file.get(), "VTKHDF/Steps");
      hdf5::write_attribute(steps.get(), "NSteps", 1);
      if (counted)
        Column::open(file.get(), "BLOCKS/cracks/counts").truncate(0);
      else
        hdf5::check(H5Ldelete(file.get(), "BLOCKS/cracks/counts", H5P_DEFAULT));
      Column::open(file.get(), "VTKHDF/Steps/CellDataOffsets/Parent").truncate(0);
    }
    EXPECT_THAT(ResultsReader(path).cracks(), IsEmpty());
    EXPECT_THAT(ResultsReader(path).frame(0).parent, IsEmpty());
    {
      ResultsWriter writer = ResultsWriter::reopen(path, 1);
      EXPECT_FALSE(has_record(path));
      model.settings = crackable().settings;
      crack(model);
      write_next(writer, model);
    }
    EXPECT_THAT(ResultsReader(path).frame(1).parent, ElementsAre(0, 0, 2));
    EXPECT_EQ(ResultsReader(path).cracks().size(), 1U);
  }
}

TEST(ResultsCracks, AreRefusedIfTheyDoNotFitTheFile) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.vtkhdf";
  const auto refusal = [&](const char* dataset, auto value) {
    Model model = crackable();
    crack(model);
    {
      ResultsWriter writer(path, identity);
      write_next(writer, model);
    }
    {
      const hdf5::Handle file = hdf5::open_file(path, true);
      Column::open(file.get(), std::string("BLOCKS/cracks/") + dataset)
          .put(0, &value, 1);
    }
    return file_error([&] { ResultsReader(path).cracks(); });
  };
  EXPECT_EQ(refusal("step", std::int64_t{8}), "");
  EXPECT_THAT(refusal("counts", std::int64_t{-1}), HasSubstr("counts is negative"));
  EXPECT_THAT(refusal("counts", std::int64_t{1} << 60), HasSubstr("cannot read"));
  EXPECT_THAT(refusal("child", 0), HasSubstr("block 0 is not in 1 to 3"));
}

json summary_of(const Model& model) {
  const TemporaryFolder folder;
  write_summary(folder / "a.summary.json", model, {identity, {}, 1.5, "done", 4});
  return json::parse(samples::contents(folder / "a.summary.json"));
}

TEST(SummaryCracks, HasCracksCountsAndRefusals) {
  EXPECT_FALSE(summary_of(samples::two_blocks()).contains("cracks"));
  Model model = crackable();
  EXPECT_EQ(summary_of(model)["cracks"], json::array());
  crack(model);
  crack(model, CrackCause::point_loads);
  for (const int block : {0, 1})
    refuse_crack(model.crack_refusals, {block, CrackRefusal::small});
  refuse_crack(model.crack_refusals, {1, CrackRefusal::full});
  model.time_step.pieces = true;
  const json summary = summary_of(model);
  EXPECT_EQ(summary["dt"]["pieces"], true);
  EXPECT_EQ(summary["crack_counts"],
            json({{"all", 2}, {"stress", 1}, {"point loads", 1}}));
  EXPECT_EQ(summary["refused_cracks"],
            json({{"a piece would be smaller than amin", {1, 2}},
                  {"START allows no more blocks", {2}}}));
  const json second = summary["cracks"][1];
  EXPECT_EQ(second["parent"], 2);
  EXPECT_EQ(second["child"], 4);
  EXPECT_EQ(second["cause"], "point loads");
  EXPECT_EQ(second["from"], json({-1.5, 4.5}));
  EXPECT_EQ(second["to"], json({1.5, 0.5}));
  EXPECT_EQ(second["areas"], json({5.0, 3.0}));
  EXPECT_NEAR(second["angle"], 126.8698976458, 1e-9);
  EXPECT_EQ(second["kinetic"], json({8.0, 6.5}));
  EXPECT_EQ(second["strain"], json({20.0, 2.25}));
  EXPECT_EQ(second["released"], 19.25);
}

TEST(ListingCracks, TellsTheRulesAndTheNumbers) {
  const TemporaryFolder folder;
  const auto listed = [&](const Model& model) {
    {
      Listing listing(folder / "a.out", false);
      listing.input_echo(model);
      listing.closing(model);
    }
    return samples::contents(folder / "a.out");
  };
  EXPECT_THAT(listed(samples::two_blocks()),
              AllOf(Not(HasSubstr("CRACK")), Not(HasSubstr("crack"))));
  Model model = crackable();
  model.settings.materials[3].damping = 0.125;
  model.settings.rigid = false;
  model.time_step.elastic = model.time_step.pieces = true;
  crack(model);
  refuse_crack(model.crack_refusals, {1, CrackRefusal::small});
  const std::string text = listed(model);
  EXPECT_THAT(text, HasSubstr("material 3 (sandstone): blocks split at a tension of "
                              "1e+06, under point loads at 500000; least area of a "
                              "piece 0.25; new faces have joint id 7\n"));
  EXPECT_THAT(text, HasSubstr("material 3 (sandstone): vibration of blocks damped by "
                              "0.125 of critical\n"));
  EXPECT_THAT(text, HasSubstr("the time step is set by block 2 (the elasticity of a "
                              "piece of it)\n"));
  EXPECT_THAT(text,
              HasSubstr("  cracks                                            1\n"
                        "    1 block did not split at first: a piece would be smaller "
                        "than amin\n"));
}

}  // namespace
}  // namespace blocks::output
