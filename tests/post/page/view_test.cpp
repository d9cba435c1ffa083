// The content of the page of `blocks view`. view_page_test.py and view_tools_test.py
// test its behaviour in a browser.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "draw/colour_map.hpp"
#include "files/hdf5_handle.hpp"
#include "output/sample_model.hpp"
#include "post/page/view_data.hpp"
#include "post/page/view_numbers.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

float six_digits(double value) { return post::float_of(post::six_digits_of(value)); }

// The page shows six digits of a float. A plain conversion from double to float would
// change some of them.
TEST(View, KeepsSixDigitsInAFloat) {
  std::mt19937_64 random(1982);
  std::uniform_real_distribution<double> mantissa(1, 10);
  std::uniform_int_distribution<int> power(-30, 30);
  int plain_fails = 0;
  const auto digits = [](double value) { return fmt::format("{:.6g}", value); };
  for (int i = 0; i < 100000; ++i) {
    const double value =
        (i % 2 ? -1 : 1) * mantissa(random) * std::pow(10.0, power(random));
    const double kept = six_digits(value);
    ASSERT_EQ(digits(kept), digits(value));
    plain_fails += digits(static_cast<float>(value)) != digits(value);
  }
  EXPECT_GT(plain_fails, 0);
  EXPECT_EQ(six_digits(1e-40), 0.0F);
}

// A guess plus its difference is the number, for any guess.
TEST(View, StoresNumbersAsDifferencesFromAGuess) {
  post::DigitColumn column{2, {}, {}};
  const double inf = std::numeric_limits<double>::infinity();
  for (const double value :
       {1.0, -2e-30, 1.00001, 0.0, -inf, std::nan(""), 999999.4, 7e30, 0.0, -7e30})
    column.add(value);
  EXPECT_EQ(column.shown[4], -inf);
  EXPECT_TRUE(std::isnan(column.shown[5]));
  EXPECT_EQ(column.exact[3].power,
            column.exact[1].power);  // A zero has the power of the number before.
  const auto in_time = post::TimeGuess{true}.of(column);
  EXPECT_EQ(post::differences(column, in_time)[2],
            2U);  // The difference is one, and signs are folded.
  for (const double guess : {0.0, 1e300, -inf, std::nan("")}) {
    const auto told = post::differences(column, [=](std::size_t) { return guess; });
    for (std::size_t i = 0; i < told.size(); ++i) {
      const std::int64_t miss =
          told[i] % 2 ? -std::int64_t{told[i] / 2} - 1 : told[i] / 2;
      const bool none = std::isnan(guess) || guess == 0.0 ||
                        column.exact[i].power == post::not_finite;
      const double start = none ? 0 : guess > 0 ? 999999 : -999999;
      EXPECT_EQ(start + static_cast<double>(miss), column.exact[i].digits)
          << guess << " " << i;
    }
  }
}

TEST(View, KeepsAnOlderPage) {
  const TemporaryFolder folder;
  run_text(folder, "fall",
           preliminary() + rectangle(0, 0, 1, 1) + "GRAVITY, 0, -10\nCYCLE, 9\n");
  folder.write("fall.html", "mine");
  for (int i = 0; i < 2; ++i)
    ASSERT_EQ(blocks("view fall.vtkhdf", folder.path()).code, 0);
  EXPECT_EQ(slurp(folder / "fall.html.bak"), "mine");
}

TEST(View, WritesOnePage) {
  const TemporaryFolder folder;
  run_text(folder, "fall",
           preliminary() + rectangle(0, 0, 1, 1) + "GRAVITY, 0, -10\nCYCLE, 9\n");
  ASSERT_EQ(blocks("view fall.vtkhdf", folder.path()).code, 0);
  const std::string page = slurp(folder / "fall.html");
  EXPECT_THAT(page, HasSubstr("\"blocks\":1"));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
}

// The page has the colours of the maps of figures. Their number is odd, so that zero
// has the colour in the middle of a diverging map.
TEST(View, OffersTheColourMapsOfFigures) {
  const TemporaryFolder folder;
  run_text(folder, "fall", preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  const post::ViewData data =
      post::view_data(post::ResultsReader((folder / "fall.vtkhdf").string()), 1);
  const auto maps = nlohmann::json::parse(data.meta)["maps"];
  ASSERT_EQ(maps.size(), 5U);
  for (const auto& [name, map] : maps.items()) {
    EXPECT_EQ(map["diverging"], draw::colour_map(name).diverging);
    EXPECT_EQ(map["colours"].size() % 2, 1U);
  }
  const auto& zero = maps["bluered"]["colours"];
  EXPECT_EQ(zero[zero.size() / 2], "#f7f7f7");
  EXPECT_EQ(maps["viridis"]["colours"].front(), "#440154");
  EXPECT_EQ(maps["grey"]["colours"].back(), "#1c1c1c");
}

TEST(View, KnowsUnitsOnlyIfTheyAreNamed) {
  const TemporaryFolder folder;
  run_text(folder, "fall", preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  post::ResultsReader results((folder / "fall.vtkhdf").string());
  const auto meta = [&] {
    return nlohmann::json::parse(post::view_data(results, 1).meta);
  };
  EXPECT_EQ(meta()["units_known"], false);
  results.show_in({"cm", "g", "ms"});
  const auto named = meta();
  EXPECT_EQ(named["units_known"], true);
  EXPECT_EQ(named["length_unit"], "cm");
}

Contact touching(int corner, int edge) {
  return {corner, edge, 0.0, 0.0, 1e5, 2e4, 0.0};
}

/// A contact that acts in some frames.
struct PassingContact {
  Contact contact;
  bool acts = true;
};

/// Moves the model to its next frame. Velocities, spins, forces and stresses are random
/// numbers with six digits. Positions follow the velocities, and contacts persist.
void jolt(Model& model, std::vector<PassingContact>& passing, std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  const auto shake = [&](auto& values, double scale) {
    for (double& value : values.reshaped())
      value = scale * any(random);
  };
  Blocks& blocks = model.blocks;
  model.time += 0.01;
  model.steps += 140;
  for (int b = 0; b < blocks.size(); ++b) {
    blocks.velocity.col(b) += Vec2(any(random), any(random));
    const Vec2 way = 0.01 * blocks.velocity.col(b);
    Eigen::Matrix2d strain;
    shake(strain, 1e-3);
    const double turn = 0.01 * blocks.spin[b];
    blocks.angle[b] += turn;
    const Eigen::Matrix2d map =
        Eigen::Rotation2Dd(turn) * (Eigen::Matrix2d::Identity() + strain);
    for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
      blocks.corner.col(c) = blocks.centroid.col(b) + way +
                             map * (blocks.corner.col(c) - blocks.centroid.col(b));
    blocks.centroid.col(b) += way;
  }
  shake(blocks.spin, 3);
  shake(blocks.force, 1e6);
  shake(blocks.moment, 1e5);
  shake(blocks.stress, 1e7);
  model.contacts.clear();
  for (auto& [contact, acts] : passing) {
    if (!acts)
      contact = touching(contact.corner, contact.edge);
    if (any(random) > 0.8)
      acts = !acts;
    contact.normal_force *= 1 + 0.3 * any(random);
    contact.overlap = 1e-3 * (1 + any(random));
    if (acts)
      model.contacts.push_back(contact);
  }
}

// The results have 850 deformable blocks in motion and 100 frames.
TEST(View, NeedsLessThanFiveMegabytesForAHundredFrames) {
  const TemporaryFolder folder;
  const std::string path = (folder / "motion.vtkhdf").string();
  {
    Model model = samples::no_blocks();
    for (int b = 0; b < 850; ++b)
      samples::add_box(model, 2 * (b % 34), 2 * (b / 34), 1.9, 1.9);
    std::vector<PassingContact> passing;
    for (int i = 0; i < 3400; ++i) {
      const int b = i / 4, other = b == 0 ? 1 : b - 1;
      model.contacts.push_back(touching(i, 4 * other + i % 4));
      passing.push_back({model.contacts.back()});
    }
    std::mt19937_64 random(850);
    output::ResultsWriter results(path, {});
    for (int frame = 0; frame < 100; ++frame) {
      results.write(model);
      jolt(model, passing, random);
    }
  }
  const post::ViewData page = post::view_data(post::ResultsReader(path), 1);
  EXPECT_LT(page.packed.size() + page.meta.size(), 5'000'000U);
  EXPECT_GT(page.packed.size(), 2'000'000U);  // Otherwise nothing has moved.
}

// The title has tags that would end the script of the page.
TEST(View, EscapesTheTitle) {
  const TemporaryFolder folder;
  std::string deck = preliminary();
  const auto line = deck.find('\n') + 1;
  deck.replace(line, deck.find('\n', line) - line, "</script><script>alert(1)");
  run_text(folder, "fall", deck + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  ASSERT_EQ(blocks("view fall.vtkhdf", folder.path()).code, 0);
  const std::string page = slurp(folder / "fall.html");
  EXPECT_THAT(page, HasSubstr("\\u003c/script>"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
}

TEST(View, RefusesAContactAtAMissingCorner) {
  const TemporaryFolder folder;
  run_text(folder, "two",
           preliminary() + rectangle(0, 0, 1, 1, true) + rectangle(0, 1, 1, 2) +
               "GRAVITY, 0, -10\nCYCLE, 40\n");
  {
    using hdf5::check, hdf5::Handle;
    const Handle file = hdf5::open_file((folder / "two.vtkhdf").string(), true);
    const Handle corner(H5Dopen2(file.get(), "BLOCKS/contacts/Corner", H5P_DEFAULT),
                        H5Dclose);
    const Handle space(H5Dget_space(corner.get()), H5Sclose);
    const auto count =
        static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space.get())));
    ASSERT_GT(count, 0U);
    const std::vector<int> wrong(count, 2000000000);
    check(H5Dwrite(corner.get(), H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                   wrong.data()));
  }
  const Outcome run = blocks("view two.vtkhdf", folder.path());
  EXPECT_EQ(run.code, 5);
  EXPECT_THAT(run.err, HasSubstr("cannot read two.vtkhdf: contacts/Corner is out of "
                                 "range: 2000000000 is not in 1 to "));
}

TEST(View, NamesTheFileThatItCannotRead) {
  const TemporaryFolder folder;
  folder.write("text.vtkhdf", "no results");
  for (const char* name : {"text.vtkhdf", "none.vtkhdf"}) {
    const Outcome run = blocks(std::string("view ") + name, folder.path());
    EXPECT_EQ(run.code, 5);
    EXPECT_THAT(run.err, HasSubstr(std::string("cannot read ") + name));
  }
  EXPECT_FALSE(folder.holds("text.html"));
  EXPECT_EQ(blocks("view none.vtkhdf --every 0", folder.path()).code, 2);
}

}  // namespace
}  // namespace blocks::testing
