// Units and names of materials of a deck (UNITS, MATERIAL) in results, figures, tables
// and pages.
#include "post/read/units.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "output/results/results_names.hpp"
#include "post/page/view_data.hpp"
#include "post/read/frame_quantity.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

/// A deck of two blocks in cm, g, ms. One block falls onto the other, which is fixed.
std::string deck(const std::string& units) {
  std::string text =
      preliminary() + rectangle(-5, -1, 5, 0, true) + rectangle(0, 0.001, 1, 1) +
      "GRAVITY, 1, -10\nPLOTS, 0.01\nHISTORY, 0.01, unbalanced:2\nCYCLE, 100\n";
  const auto end = text.find("\nEND\n") + 1;
  text.insert(end, units);
  const auto material = text.find("MATERIAL, 1");
  text.insert(text.find('\n', material), ", 'grey rock'");
  return text;
}

class NamedUnits : public ::testing::Test {
 protected:
  void SetUp() override { run_text(folder_, "fall", deck("UNITS, cm, g, ms\n")); }
  Outcome run(const std::string& command) const {
    return blocks(command, folder_.path());
  }
  std::string path() const { return (folder_ / "fall.vtkhdf").string(); }
  TemporaryFolder folder_;
};

TEST_F(NamedUnits, AreShownWithoutOptions) {
  const Outcome table = run("history fall.vtkhdf -q speed:2,s22:2");
  ASSERT_EQ(table.code, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("cm ms⁻¹"));
  EXPECT_THAT(table.out, HasSubstr("g cm⁻¹ ms⁻²"));
  ASSERT_EQ(run("plot fall.vtkhdf --colour speed -o fall.svg").code, 0);
  EXPECT_THAT(slurp(folder_ / "fall.svg"), HasSubstr("[cm ms⁻¹]"));
  const auto meta =
      nlohmann::json::parse(post::view_data(post::ResultsReader(path()), 1).meta);
  EXPECT_EQ(meta["units_known"], true);
  EXPECT_EQ(meta["length_unit"], "cm");
}

// Every value is that of the file times the factor of its dimension.
TEST_F(NamedUnits, AreConvertedToOthers) {
  const post::ResultsReader as_stored(path());
  post::ResultsReader converted(path());
  converted.show_in({"m", "kg", "s"});
  const post::UnitScale scale{1e-2, 1e-3, 1e-3};
  const long last = as_stored.frames() - 1;
  const post::Frame a = as_stored.frame(last), b = converted.frame(last);
  const post::Frame a0 = as_stored.frame(0), b0 = converted.frame(0);
  const auto near = [](double is, double should) {
    EXPECT_NEAR(is, should, 1e-12 * std::abs(should));
  };
  near(b.time, 1e-3 * a.time);
  near(converted.times().back(), 1e-3 * as_stored.times().back());
  near(b.kinetic_energy, scale.of({1, 1, -2}) * a.kinetic_energy);
  for (const post::QuantityKind& kind : quantities::quantity_kinds()) {
    const Eigen::VectorXd should = scale.of(kind.dimension) * values_of(kind, a, a0);
    const Eigen::VectorXd is = values_of(kind, b, b0);
    EXPECT_LE((is - should).norm(), 1e-12 * should.norm()) << kind.name;
  }
  const post::FrameContacts p = as_stored.contacts(last), q = converted.contacts(last);
  ASSERT_GT(p.size(), 0);
  for (int i = 0; i < p.size(); ++i) {
    near(q.overlap[i], 1e-2 * p.overlap[i]);
    near(q.normal_force[i], scale.of({0, 1, -2}) * p.normal_force[i]);
    near(q.point(0, i), 1e-2 * p.point(0, i));
  }
}

TEST_F(NamedUnits, AreNeverReplacedByOneThatIsUnknown) {
  for (const char* command : {"history", "plot", "view"}) {
    const Outcome refused = run(std::string(command) + " fall.vtkhdf --units ell,kg,s");
    EXPECT_EQ(refused.code, 2) << command;
    EXPECT_THAT(refused.err,
                HasSubstr("fall.vtkhdf is in cm,g,ms, not in ell,kg,s: 'ell' cannot be "
                          "converted; known are m, mm, cm"));
  }
}

// The time asked for is in the units that are shown.
TEST_F(NamedUnits, HoldForTimesOfTheCommandLine) {
  const Outcome plot =
      run("plot fall.vtkhdf --units m,kg,s -t 0.00002 -o late.svg --colour x");
  ASSERT_EQ(plot.code, 0) << plot.err;
  EXPECT_THAT(slurp(folder_ / "late.svg"),
              HasSubstr("t = 1.999e−05 s, nearest to 2e−05 s"));
}

// Runs of one figure are shown in the units of the first.
TEST_F(NamedUnits, AreTheSameForAllRunsOfATable) {
  run_text(folder_, "other", deck("UNITS, m, kg, s\n"));
  const Outcome both = run("history fall.vtkhdf other.vtkhdf -q y:2 --csv");
  ASSERT_EQ(both.code, 0) << both.err;
  EXPECT_THAT(both.out, HasSubstr("fall.vtkhdf,0,0.5005"));
  EXPECT_THAT(both.out, HasSubstr("other.vtkhdf,0,50.05"));
}

// Nothing tells the units of the other run, so they are not taken from this one.
TEST_F(NamedUnits, AreNotGivenToARunWithoutThem) {
  run_text(folder_, "plain", deck(""));
  const Outcome mixed = run("history fall.vtkhdf plain.vtkhdf -q y:2");
  EXPECT_EQ(mixed.code, 2);
  EXPECT_THAT(
      mixed.err,
      HasSubstr("fall.vtkhdf is in cm,g,ms, but the deck of plain.vtkhdf has no "
                "UNITS card\n  hint: --units cm,g,ms means"));
  EXPECT_EQ(run("history fall.vtkhdf plain.vtkhdf -q y:2 --units cm,g,ms").code, 0);
}

TEST_F(NamedUnits, AreKeptByARestart) {
  run_text(folder_, "more", "RESTART, fall.ckpt.h5\nCYCLE, 10\n");
  EXPECT_EQ(post::ResultsReader((folder_ / "more.vtkhdf").string()).units(),
            (Units{"cm", "g", "ms"}));
}

TEST_F(NamedUnits, AreInTheListing) {
  const std::string listing = slurp(folder_ / "fall.out");
  EXPECT_THAT(listing, HasSubstr("units of length, mass, time"));
  EXPECT_THAT(listing, HasSubstr("cm, g, ms"));
  EXPECT_THAT(listing, HasSubstr("grey rock"));
}

TEST_F(NamedUnits, DoNotChangeTheMotion) {
  run_text(folder_, "plain", deck(""));
  const post::ResultsReader a(path()), b((folder_ / "plain.vtkhdf").string());
  EXPECT_FALSE(b.units());
  const post::Frame x = a.frame(a.frames() - 1), y = b.frame(b.frames() - 1);
  EXPECT_EQ(x.centroid, y.centroid);
}

TEST_F(NamedUnits, ComeWithTheNamesOfMaterials) {
  const auto meta =
      nlohmann::json::parse(post::view_data(post::ResultsReader(path()), 1).meta);
  EXPECT_EQ(meta["material_names"]["1"], "grey rock");
  ASSERT_EQ(run("plot fall.vtkhdf -o rock.svg --materials 'grey rock=RED'").code, 0);
  EXPECT_THAT(slurp(folder_ / "rock.svg"), HasSubstr(">grey rock<"));
}

// Export and import keep the names in both formats that can hold them.
TEST_F(NamedUnits, MaterialNamesSurviveExportAndImport) {
  for (const char* form : {"geojson", "msh"}) {
    const std::string file = std::string("out.") + form;
    ASSERT_EQ(run("export fall.vtkhdf -t 0 -o " + file).code, 0);
    ASSERT_EQ(run("import " + file + " -o back.mesh.txt --deck").code, 0);
    EXPECT_THAT(slurp(folder_ / "back.deck"),
                HasSubstr("MATERIAL, 1, 1.E10, 4.E9, 2500, 'grey rock'"))
        << form;
    EXPECT_EQ(run("check back.deck").code, 0);
  }
}

// Two materials: one whose name has a comma, and one without a name.
class NamedMaterials : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string text =
        preliminary() + rectangle(-5, -1, 5, 0, true) +
        "CREATE, 4, 2\n0, 0, 1, 1\n0.001, 1, 1, 0.001\n"
        "HISTORY, 0.01, 'y:material=soft, old clay:P90', ke\nCYCLE, 50\n";
    text.insert(text.find('\n', text.find("MATERIAL, 2")), ", 'soft, old clay'");
    run_text(folder_, "clay", text);
  }
  Outcome run(const std::string& command) const {
    return blocks(command, folder_.path());
  }
  TemporaryFolder folder_;
};

TEST_F(NamedMaterials, AreAskedForInQuotes) {
  const Outcome number = run("history clay.vtkhdf --csv -q y:material=2:p90,ke");
  ASSERT_EQ(number.code, 0) << number.err;
  const auto values = [](const std::string& csv) { return csv.substr(csv.find("\n")); };
  for (const std::string quantity :
       {"y:material=\"soft, old clay\":p90", "\"y:material=soft, old clay:P90\""}) {
    const Outcome name = run("history clay.vtkhdf --csv -q '" + quantity + ",ke'");
    EXPECT_EQ(name.code, 0) << name.err;
    EXPECT_EQ(name.err, "") << "the samples are used";
    EXPECT_EQ(values(name.out), values(number.out));
  }
  EXPECT_EQ(
      run("history clay.vtkhdf -q ke --against '\"y:material=soft, old clay\"'").code,
      0);
  const Outcome open = run("history clay.vtkhdf -q '\"y:material=soft, old clay'");
  EXPECT_EQ(open.code, 2);
  EXPECT_THAT(open.err, HasSubstr("the quote is not closed in \"y:material=soft"));
}

TEST_F(NamedMaterials, AreColouredInQuotes) {
  const Outcome plot = run("plot clay.vtkhdf -o clay.svg "
                           "--materials '1=BLUE,\"soft, old clay\"=#123456'");
  ASSERT_EQ(plot.code, 0) << plot.err;
  EXPECT_THAT(slurp(folder_ / "clay.svg"), HasSubstr(">soft, old clay<"));
}

TEST_F(NamedMaterials, AreListedWithTheirNames) {
  EXPECT_THAT(
      run("plot clay.vtkhdf --materials rok=RED").err,
      HasSubstr("there is no material rok in clay.vtkhdf\n  hint: materials: 1, 2 "
                "(soft, old clay)\n"));
  EXPECT_THAT(run("history clay.vtkhdf -q sped").err,
              HasSubstr("there is no quantity 'sped'\n  hint: of blocks"));
  folder_.write("cards", "RED, 3\n");
  EXPECT_THAT(run("plot clay.vtkhdf --dblock cards").err,
              HasSubstr("the results have 1, 2 (soft, old clay)\n"));
}

TEST(ResultsNames, AreNotWrittenForADeckWithoutThem) {
  const TemporaryFolder folder;
  run_text(folder, "plain", preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  const auto file = hdf5::open_file((folder / "plain.vtkhdf").string(), false);
  EXPECT_FALSE(hdf5::exists(file.get(), "BLOCKS/units"));
  EXPECT_FALSE(hdf5::exists(file.get(), "BLOCKS/materials"));
}

TEST(UnitScale, HasTheFactorOfEveryDimension) {
  const auto scale = post::UnitScale::between({"ft", "lb", "min"}, {"in", "kg", "s"});
  EXPECT_DOUBLE_EQ(scale.length, 12.0);
  EXPECT_DOUBLE_EQ(scale.mass, 0.45359237);
  EXPECT_DOUBLE_EQ(scale.of({1, 0, -1}), 0.2);
  EXPECT_TRUE(
      post::UnitScale::between({"ell", "kg", "s"}, {"ell", "kg", "s"}).is_one());
}

}  // namespace
}  // namespace blocks::testing
