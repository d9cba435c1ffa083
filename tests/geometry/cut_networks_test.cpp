// Awkward networks of joints: the certified result is judged by exact areas, without
// any predicate of the library. A network is refused only with a place.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "geometry/cut.hpp"
#include "tests/geometry/cut_scenes.hpp"

namespace blocks::geometry {
namespace {

using testing::expect_tiling;
using testing::number;

// Ends of joints in a square of side 1, as multiples of 1e-6 in decimals or as doubles.
struct Draw {
  explicit Draw(unsigned seed) : random(seed) {}
  double part() { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }
  int below(int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }
  std::mt19937_64 random;
};

using Ends = std::vector<std::pair<Vec2, Vec2>>;

Ends random_traces(Draw& draw) {
  Ends ends;
  for (int i = 0; i < 14; ++i)
    ends.push_back({{draw.part(), draw.part()}, {draw.part(), draw.part()}});
  return ends;
}

Ends nearly_parallel(Draw& draw) {
  Ends ends;
  for (int i = 0; i < 12; ++i) {
    const double tilt = 1e-7 * draw.part();
    ends.push_back({{-0.1, 0.5 + 1e-7 * draw.part()}, {1.1, 0.5 + tilt}});
  }
  ends.push_back({{0.3, -0.1}, {0.4, 1.1}});
  return ends;
}

Ends through_one_point(Draw& draw) {
  Ends ends;
  for (int i = 0; i < 10; ++i) {
    const double angle = std::numbers::pi * draw.part();
    const Vec2 d(1.5 * std::cos(angle), 1.5 * std::sin(angle)), p(0.37, 0.61);
    ends.push_back({p - d, p + d});  // rounding makes them miss the point by 1e-16
  }
  return ends;
}

Ends traces_on_traces(Draw& draw) {
  Ends ends = {{{0.0, 0.4}, {1.0, 0.6}}, {{0.5, 0.0}, {0.45, 1.0}}};
  for (int i = 0; i < 12;
       ++i) {  // from a rounded point of one trace to that of another
    const auto& a =
        ends[static_cast<std::size_t>(draw.below(static_cast<int>(ends.size())))];
    const auto& b =
        ends[static_cast<std::size_t>(draw.below(static_cast<int>(ends.size())))];
    ends.push_back({a.first + draw.part() * (a.second - a.first),
                    b.first + draw.part() * (b.second - b.first)});
  }
  return ends;
}

// Few coordinates, so that joints overlap, repeat, follow the outline and end on
// corners.
Ends lattice(Draw& draw) {
  Ends ends;
  for (int i = 0; i < 16; ++i)
    ends.push_back({{draw.below(5) / 4.0, draw.below(5) / 4.0},
                    {draw.below(5) / 4.0, draw.below(5) / 4.0}});
  return ends;
}

// A number as the deck may give it: scale * value + offset, in decimals.
Decimal decimal(double value, const std::string& scale, long offset) {
  const long micro = std::lround(value * 1e6);
  const Decimal unit = number(scale);
  // value * 1e6 is whole, so that the product is a decimal with the exponent of the
  // scale; the offset is a multiple of it.
  const long shift = offset * 1000000;
  return number(std::to_string(micro + shift) + "e" +
                std::to_string(unit.exponent() - 6));
}

TEST(CutNetworks, CertifiedNetworksTileAndAreRefusedOnlyWithAPlace) {
  const std::vector<std::function<Ends(Draw&)>> families = {
      random_traces, nearly_parallel, through_one_point, traces_on_traces, lattice};
  int certified = 0, refused = 0;
  for (std::size_t family = 0; family < families.size(); ++family)
    for (unsigned seed = 0; seed < 24; ++seed) {
      Draw draw(100 * static_cast<unsigned>(family) + seed);
      const std::string scale = std::vector<std::string>{"1", "1e-6", "1e6"}[seed % 3];
      const long offset = seed % 4 == 3 ? 1000 : seed % 8 == 6 ? 1000000000 : 0;
      const auto place = [&](const Vec2& p) {
        return DecimalPoint{decimal(p.x(), scale, offset),
                            decimal(p.y(), scale, -offset)};
      };
      CutRequest cuts;
      for (const Vec2& corner :
           seed % 2 == 0 ? Polygon{{0, 0}, {0, 1}, {1, 1}, {1, 0}}
                         : Polygon{{0, 0}, {0.25, 1}, {0.5, 0.5}, {1, 1}, {0.9, 0}})
        cuts.outline.push_back(place(corner));
      int id = 0;
      for (const auto& [from, to] : families[family](draw))
        cuts.joints.push_back({place(from), place(to), ++id % 3});
      if (seed % 5 == 4) {
        cuts.emin = 1e-3 * number(scale).value();
        cuts.amin = 1e-6 * number(scale).value() * number(scale).value();
      }
      SCOPED_TRACE(::testing::Message() << "family " << family << ", seed " << seed);
      try {
        expect_tiling(cut_outline(cuts));
        ++certified;
      } catch (const CutError& error) {
        EXPECT_EQ(error.kind, CutError::Kind::certificate) << error.what();
        EXPECT_TRUE(error.place.allFinite());
        EXPECT_GE(offset, 1000) << error.what();
        ++refused;
      }
    }
  EXPECT_GE(certified, 100);
  RecordProperty("refused", refused);
}

// Doubles as ends, which need not be short decimals. Joints that coincide up to
// rounding may remain after cleaning; they are refused.
TEST(CutNetworks, JointsInDoublesTileAfterCleaning) {
  int certified = 0;
  for (const auto& family :
       {random_traces, nearly_parallel, through_one_point, traces_on_traces})
    for (unsigned seed = 0; seed < 12; ++seed) {
      Draw draw(seed);
      CutRequest cuts = testing::request("0 0 0 1 1 1 1 0", {});
      for (const auto& [from, to] : family(draw))
        cuts.joints.push_back({from, to, 1});
      cuts.emin = 1e-9;
      cuts.amin = 1e-14;
      try {
        expect_tiling(cut_outline(cuts));
        ++certified;
      } catch (const CutError& error) {
        EXPECT_EQ(error.kind, CutError::Kind::certificate) << error.what();
        EXPECT_TRUE(family == traces_on_traces) << seed << ": " << error.what();
      }
    }
  EXPECT_GE(certified, 44);
}

}  // namespace
}  // namespace blocks::geometry
