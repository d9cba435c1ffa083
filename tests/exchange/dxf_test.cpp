// DXF drawings: what is read from them, and that chords are as near to their curves as
// the reader says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "exchange/block_record.hpp"
#include "exchange/chords.hpp"
#include "exchange/dxf_groups.hpp"
#include "exchange/dxf_reader.hpp"
#include "exchange/dxf_text.hpp"
#include "exchange/mutants.hpp"
#include "exchange/trace_reader.hpp"

namespace blocks::exchange {
namespace {

using geometry::Vec2;
using testing::dxf_drawing;
using testing::dxf_groups;
using testing::dxf_line;
using testing::dxf_number;
using testing::dxf_ring;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

DxfDrawing sound_drawing(const std::string& entities) {
  const std::string text = dxf_drawing(entities);
  DxfDrawing drawing = read_drawing(text);
  EXPECT_FALSE(has_errors(drawing.messages))
      << format(drawing.messages, "f.dxf", "DXF", text);
  return drawing;
}

double distance(const Vec2& p, const Vec2& from, const Vec2& to) {
  const Vec2 chord = to - from;
  const double length = chord.squaredNorm();
  const double s =
      length > 0.0 ? std::clamp((p - from).dot(chord) / length, 0.0, 1.0) : 0.0;
  return (p - from - s * chord).norm();
}

/// The largest distance of points of a curve from the chords.
double largest_distance(const std::function<Vec2(double)>& curve, const DxfLine& line) {
  std::vector<Vec2> points = line.points;
  if (line.is_closed)
    points.push_back(points.front());
  double largest = 0.0;
  for (int i = 0; i <= 2000; ++i) {
    const Vec2 p = curve(i / 2000.0);
    double nearest = HUGE_VAL;
    for (std::size_t k = 1; k < points.size(); ++k)
      nearest = std::min(nearest, distance(p, points[k - 1], points[k]));
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// Requires the error that the drawing states, and that it is not overstated tenfold.
void expect_chords(const std::function<Vec2(double)>& curve, const DxfDrawing& drawing,
                   double size) {
  ASSERT_EQ(drawing.lines.size(), 1u);
  const double found = largest_distance(curve, drawing.lines[0]);
  EXPECT_LE(found, drawing.chord_error + 1e-12 * size);
  EXPECT_GE(found, 0.1 * drawing.chord_error);
  EXPECT_LE(drawing.chord_error, chord_part * size * (1.0 + 1e-12));
}

TEST(Dxf, ChordsOfArcsAreAsNearAsStated) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int trial = 0; trial < 50; ++trial) {
    const double x = 100 * part(random), y = -1e3 * part(random),
                 r = std::pow(10.0, 6 * part(random) - 3),
                 from = 720 * part(random) - 360,
                 turn = trial == 0 ? 90 : 1 + 358 * part(random);
    const DxfDrawing drawing =
        sound_drawing(dxf_groups({{0, "ARC"},
                                  {8, "0"},
                                  {10, dxf_number(x)},
                                  {20, dxf_number(y)},
                                  {40, dxf_number(r)},
                                  {50, dxf_number(from)},
                                  {51, dxf_number(from + turn)}}));
    expect_chords(
        [&](double s) {
          const double angle = (from + s * turn) * std::numbers::pi / 180.0;
          return Vec2(x + r * std::cos(angle), y + r * std::sin(angle));
        },
        drawing, 2.0 * std::numbers::sqrt2 * r + 1e3);
    EXPECT_LE(drawing.chord_error, chord_part * 2.0 * std::numbers::sqrt2 * r * 1.001);
    EXPECT_FALSE(drawing.lines[0].is_closed);
  }
}

TEST(Dxf, ACircleIsAClosedLineOnItsRadius) {
  const DxfDrawing drawing = sound_drawing(
      dxf_groups({{0, "CIRCLE"}, {8, "hole"}, {10, "3"}, {20, "4"}, {40, "2"}}));
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_TRUE(drawing.lines[0].is_closed);
  EXPECT_EQ(drawing.lines[0].points.front(), Vec2(5, 4));
  for (const Vec2& p : drawing.lines[0].points)
    EXPECT_NEAR((p - Vec2(3, 4)).norm(), 2.0, 1e-14);
  EXPECT_THAT(drawing.layers, ElementsAre("hole"));
}

TEST(Dxf, ChordsOfEllipsesAreAsNearAsStated) {
  const double from = 0.3, to = 4.1;
  const Vec2 major(3, 1), minor = 0.4 * Vec2(-1, 3);
  const DxfDrawing drawing = sound_drawing(dxf_groups({{0, "ELLIPSE"},
                                                       {8, "0"},
                                                       {10, "1"},
                                                       {20, "2"},
                                                       {11, "3"},
                                                       {21, "1"},
                                                       {40, "0.4"},
                                                       {41, dxf_number(from)},
                                                       {42, dxf_number(to)}}));
  expect_chords(
      [&](double s) {
        const double t = from + s * (to - from);
        return Vec2(Vec2(1, 2) + std::cos(t) * major + std::sin(t) * minor);
      },
      drawing, 2.0 * std::numbers::sqrt2 * major.norm());
  const DxfDrawing whole = sound_drawing(dxf_groups({{0, "ELLIPSE"},
                                                     {8, "0"},
                                                     {10, "1"},
                                                     {20, "2"},
                                                     {11, "3"},
                                                     {21, "1"},
                                                     {40, "0.4"},
                                                     {41, "0"},
                                                     {42, "6.283185307179586"}}));
  EXPECT_TRUE(whole.lines.at(0).is_closed);
}

/// The point of a spline by the recursion of Cox and de Boor, which the reader does not
/// use.
Vec2 point_of(const Spline& spline, double u) {
  const std::function<double(std::size_t, int)> basis = [&](std::size_t i, int p) {
    const auto& t = spline.knots;
    if (p == 0)
      return t[i] <= u && u < t[i + 1] ? 1.0 : 0.0;
    const auto q = static_cast<std::size_t>(p);
    double sum = 0.0;
    if (t[i + q] > t[i])
      sum += (u - t[i]) / (t[i + q] - t[i]) * basis(i, p - 1);
    if (t[i + q + 1] > t[i + 1])
      sum += (t[i + q + 1] - u) / (t[i + q + 1] - t[i + 1]) * basis(i + 1, p - 1);
    return sum;
  };
  Vec2 sum = Vec2::Zero();
  double weight = 0.0;
  for (std::size_t i = 0; i < spline.points.size(); ++i) {
    const double w = spline.weights[i] * basis(i, spline.degree);
    sum += w * spline.points[i];
    weight += w;
  }
  return sum / weight;
}

TEST(Dxf, ChordsOfSplinesAreAsNearAsStated) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int trial = 0; trial < 40; ++trial) {
    Spline spline;
    spline.degree = 1 + trial % 5;
    const auto p = static_cast<std::size_t>(spline.degree);
    const std::size_t n = p + 1 + random() % 6;
    double knot = part(random);
    for (std::size_t i = 0; i < n + p + 1; ++i) {
      // Every other trial has equal knots at both ends, as drawing programs do.
      const bool repeats = trial % 2 == 0 && ((i > 0 && i <= p) || i > n);
      knot += repeats ? 0.0 : 0.1 + part(random);
      spline.knots.push_back(knot);
    }
    testing::DxfGroups groups = {{0, "SPLINE"},
                                 {8, "s"},
                                 {70, "8"},
                                 {71, std::to_string(p)},
                                 {72, std::to_string(spline.knots.size())},
                                 {73, std::to_string(n)},
                                 {74, "0"}};
    for (const double value : spline.knots)
      groups.emplace_back(40, dxf_number(value));
    double size = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      spline.points.emplace_back(10 * part(random), 5 * part(random));
      spline.weights.push_back(trial % 3 == 0 ? 0.2 + part(random) : 1.0);
      size = std::max(size, (spline.points[i] - spline.points[0]).norm());
    }
    for (const double weight : spline.weights)
      groups.emplace_back(41, dxf_number(weight));
    for (const Vec2& point : spline.points) {
      groups.emplace_back(10, dxf_number(point.x()));
      groups.emplace_back(20, dxf_number(point.y()));
      groups.emplace_back(30, "0");
    }
    ASSERT_STREQ(fault_of(spline), "");
    const DxfDrawing drawing = sound_drawing(dxf_groups(groups));
    ASSERT_EQ(drawing.lines.size(), 1u);
    const double low = spline.knots[p], high = spline.knots[n];
    const double found = largest_distance(
        [&](double s) {
          return point_of(spline, low + std::min(s, 1.0 - 1e-9) * (high - low));
        },
        drawing.lines[0]);
    EXPECT_LE(found, drawing.chord_error + 1e-7);
    EXPECT_LE(drawing.chord_error, chord_part * 2.0 * size * std::numbers::sqrt2);
    EXPECT_LT((drawing.lines[0].points.front() - point_of(spline, low)).norm(), 1e-9);
  }
}

TEST(Dxf, ReadsLinesPolylinesAndBulges) {
  const std::string polyline =
      dxf_groups({{0, "POLYLINE"}, {8, "p"}, {66, "1"}, {70, "0"}}) +
      dxf_groups({{0, "VERTEX"}, {8, "p"}, {10, "0"}, {20, "1"}}) +
      dxf_groups({{0, "VERTEX"}, {8, "p"}, {10, "2"}, {20, "1"}, {42, "1"}}) +
      dxf_groups({{0, "VERTEX"}, {8, "p"}, {10, "2"}, {20, "3"}}) +
      dxf_groups({{0, "SEQEND"}, {8, "p"}});
  const DxfDrawing drawing =
      sound_drawing(dxf_line("l", 0.1, 0.2, 1e6, -3.25) + polyline +
                    dxf_ring("ring", {{0, 0}, {0, 1}, {1, 1}}));
  ASSERT_EQ(drawing.lines.size(), 3u);
  EXPECT_THAT(drawing.lines[0].points, ElementsAre(Vec2(0.1, 0.2), Vec2(1e6, -3.25)));
  // The bulge is half a turn anticlockwise from (2, 1) to (2, 3), about (2, 2).
  const auto& points = drawing.lines[1].points;
  EXPECT_EQ(points[0], Vec2(0, 1));
  EXPECT_EQ(points[1], Vec2(2, 1));
  EXPECT_EQ(points.back(), Vec2(2, 3));
  double right = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR((points[i] - Vec2(2, 2)).norm(), 1.0, 1e-14);
    right = std::max(right, points[i].x());
  }
  EXPECT_DOUBLE_EQ(right, 3.0);
  EXPECT_TRUE(drawing.lines[2].is_closed);
  EXPECT_EQ(drawing.lines[2].points.size(), 3u);
  EXPECT_THAT(drawing.layers, ElementsAre("l", "p", "ring"));
  EXPECT_EQ(drawing.curves, 1u);
}

// Its first and last points differ by rounding. Curves whose size is lost in the
// rounding of their coordinates, or in the range of numbers, make few chords.
TEST(Dxf, PeriodicSplinesAreClosedAndDegenerateCurvesMakeFewChords) {
  testing::DxfGroups groups = {{0, "SPLINE"}, {8, "s"},  {70, "11"}, {71, "3"},
                               {72, "11"},    {73, "7"}, {74, "0"}};
  for (int knot = 0; knot < 11; ++knot)
    groups.emplace_back(40, dxf_number(0.1 * knot));
  for (int i = 0; i < 7; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i % 4) / 4.0 + 0.3;
    groups.emplace_back(10, dxf_number(7.1 + std::cos(angle)));
    groups.emplace_back(20, dxf_number(3.3 + std::sin(angle)));
  }
  const DxfDrawing round = sound_drawing(dxf_groups(groups));
  ASSERT_EQ(round.lines.size(), 1u);
  EXPECT_TRUE(round.lines[0].is_closed);

  testing::DxfGroups same = {{0, "SPLINE"}, {8, "s"},  {71, "3"},
                             {72, "8"},     {73, "4"}, {74, "0"}};
  for (int knot = 0; knot < 8; ++knot)
    same.emplace_back(40, knot < 4 ? "0" : "1");
  for (const char* weight : {"1", "0.7", "0.3", "1"}) {
    same.emplace_back(41, weight);
    same.emplace_back(10, "1000000.1");
    same.emplace_back(20, "1000000.7");
  }
  EXPECT_LE(sound_drawing(dxf_groups(same)).chords, 4u);
  const DxfDrawing huge = read_drawing(dxf_drawing(dxf_groups({{0, "LWPOLYLINE"},
                                                               {8, "0"},
                                                               {90, "2"},
                                                               {10, "0"},
                                                               {20, "0"},
                                                               {42, "1e300"},
                                                               {10, "1"},
                                                               {20, "0"}})));
  EXPECT_LE(huge.chords, 5000u);
}

// An arc that is drawn from below runs clockwise, with x reversed.
TEST(Dxf, MirrorsWhatIsDrawnFromBelow) {
  const DxfDrawing drawing = sound_drawing(dxf_groups({{0, "ARC"},
                                                       {8, "0"},
                                                       {10, "1"},
                                                       {20, "0"},
                                                       {40, "1"},
                                                       {210, "0"},
                                                       {220, "0"},
                                                       {230, "-1"},
                                                       {50, "0"},
                                                       {51, "90"}}));
  EXPECT_EQ(drawing.lines.at(0).points.front(), Vec2(-2, 0));
  EXPECT_EQ(drawing.lines.at(0).points.back(), Vec2(-1, 1));
}

TEST(Dxf, LeavesOutPaperSpaceAndBlocksAndSaysWhatElseItLeavesOut) {
  const std::string text =
      dxf_groups({{0, "SECTION"}, {2, "BLOCKS"}, {0, "BLOCK"}, {2, "north"}}) +
      dxf_line("0", 5, 5, 6, 6) + dxf_groups({{0, "ENDBLK"}, {0, "ENDSEC"}}) +
      dxf_drawing(
          dxf_line("0", 0, 0, 1, 1) +
          dxf_groups({{0, "LINE"},
                      {8, "0"},
                      {67, "1"},
                      {10, "0"},
                      {20, "0"},
                      {11, "9"},
                      {21, "9"}}) +
          dxf_groups({{0, "INSERT"}, {8, "0"}, {2, "north"}, {10, "0"}, {20, "0"}}) +
          dxf_groups({{0, "TEXT"}, {8, "0"}, {1, "N"}}) +
          dxf_groups({{0, "TEXT"}, {8, "0"}, {1, "M"}}));
  const DxfDrawing drawing = read_drawing(text);
  EXPECT_EQ(drawing.lines.size(), 1u);
  const std::string said = format(drawing.messages, "f.dxf", "DXF", text);
  EXPECT_THAT(said, HasSubstr("warning: DXF: not read: 1 INSERT, 2 TEXT"));
  EXPECT_THAT(said, HasSubstr("explode block references"));
}

TEST(Dxf, LayersGiveJointIds) {
  const auto number = [](const char* name) { return parse_layer(name).number; };
  EXPECT_EQ(number("3"), 3);
  EXPECT_EQ(number("3_bedding"), 3);
  EXPECT_EQ(number("12 main faults"), 12);
  EXPECT_EQ(number("joint_7"), 7);
  EXPECT_EQ(number("0"), std::nullopt);
  EXPECT_EQ(number("bedding"), std::nullopt);
  EXPECT_EQ(number("S1"), std::nullopt);
  EXPECT_EQ(number("-3"), std::nullopt);
  const TraceFile file = read_traces(dxf_drawing(
      dxf_line("3_bedding", 0, 0, 1, 0) + dxf_line("faults", 0, 1, 1, 1), 4));
  ASSERT_EQ(file.traces.size(), 2u);
  EXPECT_EQ(file.traces[0].joint, 3);
  EXPECT_EQ(file.traces[1].joint, std::nullopt);
  EXPECT_THAT(file.layers, ElementsAre("3_bedding", "faults"));
  EXPECT_EQ(file.traces[1].layer, 1);
  EXPECT_EQ(file.unit, "mm");
  EXPECT_EQ(file.form, "DXF");
}

TEST(Dxf, KeepsTheBitsOfBlocksAndTheirMaterials) {
  std::mt19937_64 random(3);
  std::vector<BlockRecord> blocks;
  for (int b = 1; b <= 40; ++b) {
    BlockRecord block;
    block.number = b;
    block.material = 1 + b % 3;
    block.material_name = block.material == 2 ? "granite" : "";
    for (int i = 0; i < 3 + b % 4; ++i)
      block.outline.emplace_back(std::ldexp(static_cast<double>(random()), -60 - b),
                                 std::ldexp(static_cast<double>(random()), -30));
    block.joints.assign(block.outline.size(), b % 2);
    blocks.push_back(block);
  }
  const std::string text = write_dxf(blocks, "mm");
  const OutlineFile file = read_dxf(text);
  ASSERT_EQ(file.outlines.size(), blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    EXPECT_EQ(file.outlines[b].corners, blocks[b].outline);
    EXPECT_EQ(file.outlines[b].material, blocks[b].material);
  }
  EXPECT_EQ(file.material_names, (std::map<long, std::string>{{2, "granite"}}));
  EXPECT_EQ(file.unit, "mm");
  // Sides with a joint id are lines on a layer of their own.
  const TraceFile traces = read_traces(text);
  EXPECT_EQ(std::count_if(traces.traces.begin(), traces.traces.end(),
                          [](const Trace& trace) {
                            return trace.joint == 1 && trace.points.size() == 2;
                          }),
            100);
}

// Lines without their pair, wrong counts and numbers never reach the library.
TEST(Dxf, MutantsAreReadOrRefused) {
  const std::string seed = dxf_drawing(
      dxf_line("3_bedding", 0, 0, 1.5, 0) + dxf_ring("ring", {{0, 0}, {0, 1}, {1, 1}}) +
          dxf_groups({{0, "CIRCLE"}, {8, "0"}, {10, "1"}, {20, "1"}, {40, "2"}}) +
          dxf_groups({{0, "SPLINE"},
                      {8, "0"},
                      {71, "2"},
                      {72, "6"},
                      {73, "3"},
                      {74, "0"},
                      {40, "0"},
                      {40, "0"},
                      {40, "0"},
                      {40, "1"},
                      {40, "1"},
                      {40, "1"},
                      {10, "0"},
                      {20, "0"},
                      {10, "1"},
                      {20, "1"},
                      {10, "2"},
                      {20, "0"}}),
      6);
  const std::vector<std::string> splices = {"-",
                                            "1e999",
                                            "2147483647",
                                            "nan",
                                            "\n",
                                            "  0\nLINE\n",
                                            " 90\n1000000000\n",
                                            " 72\n-5\n",
                                            "  0\nSEQEND\n",
                                            "3DFACE",
                                            "\xff",
                                            std::string(1100, 'x'),
                                            "  0\nPOLYLINE\n"};
  std::mt19937 random(2005);
  std::size_t read = 0, refused = 0;
  for (int mutant = 0; mutant < 6000; ++mutant) {
    const std::string bytes = testing::mutant_of(seed, splices, random);
    const DxfDrawing drawing = read_drawing(bytes);
    format(drawing.messages, "mutant", "DXF", bytes);
    if (has_errors(drawing.messages)) {
      ++refused;
      continue;
    }
    ++read;
    for (const DxfLine& line : drawing.lines)
      for (const Vec2& point : line.points)
        ASSERT_TRUE(point.allFinite());
    read_dxf(bytes);
    read_traces(bytes);
  }
  EXPECT_GT(read, 500u);
  EXPECT_GT(refused, 1000u);
}

}  // namespace
}  // namespace blocks::exchange
