// Covered sides of the contact rule against an oracle on boost's rationals, written
// from docs/contact-rule.md#covered-sides: 0 wrong.
#include "geometry/covered_side.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "contact_judge.hpp"

namespace blocks::geometry {
namespace {

/// One question, with the polygons that it is about.
struct Scene {
  Polygon own, other;
  std::vector<Polygon> neighbours;
  int side = 0;
  bool at_start = true;

  template <class Map> void transform(Map&& map) {
    const auto apply = [&](Polygon& polygon) {
      for (Vec2& corner : polygon)
        corner = map(corner);
    };
    apply(own), apply(other);
    for (Polygon& neighbour : neighbours)
      apply(neighbour);
  }
  /// Coordinates are finite and no side has length zero, as `covering` requires.
  bool is_proper() const {
    const auto proper = [](const Polygon& p) {
      for (std::size_t i = 0; i < p.size(); ++i)
        if (!p[i].allFinite() || p[i] == p[(i + 1) % p.size()])
          return false;
      return p.size() >= 3;
    };
    return proper(own) && proper(other) &&
           std::all_of(neighbours.begin(), neighbours.end(), proper);
  }
};

// The oracle

struct Point {
  Rational x, y;
  explicit Point(const Vec2& v) : x(v.x()), y(v.y()) {}
  Point(Rational a, Rational b) : x(std::move(a)), y(std::move(b)) {}
  friend Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y};
  }
};
Rational dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
Rational cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

struct Segment {
  Point start, end;
  Point along() const { return end - start; }
};

struct Shape {
  std::vector<Point> corners;
  explicit Shape(const Polygon& polygon) {
    for (const Vec2& corner : polygon)
      corners.emplace_back(corner);
  }
  int size() const { return static_cast<int>(corners.size()); }
  Segment side(int i) const {
    return {corners[static_cast<std::size_t>(i)],
            corners[static_cast<std::size_t>((i + 1) % size())]};
  }
};

/// A depth: twice the area below a side, and the squared length of the side.
struct Depth {
  Rational area, length2;
  bool operator<(const Depth& b) const {
    return area * abs(area) * b.length2 < b.area * abs(b.area) * length2;
  }
};
Depth depth(const Segment& side, const Shape& other) {
  const Point e = side.along();
  Rational deepest = cross(other.corners[0] - side.start, e);
  for (const Point& corner : other.corners)
    deepest = std::max(deepest, Rational(cross(corner - side.start, e)));
  return {deepest, dot(e, e)};
}

struct Range {
  Rational begin, end;
  Rational length() const { return end > begin ? Rational(end - begin) : Rational(0); }
  Range common(const Range& b) const {
    return {std::max(begin, b.begin), std::min(end, b.end)};
  }
};

/// The part of a segment that lies in a convex polygon, from 0 to 1 along it.
Range part_inside(const Segment& segment, const Shape& polygon) {
  Range part{0, 1};
  for (int k = 0; k < polygon.size(); ++k) {
    const Segment side = polygon.side(k);
    // The area below the side at t is a + b t.
    const Rational a = cross(segment.start - side.start, side.along());
    const Rational b = cross(segment.along(), side.along());
    if (b == 0 && a < 0)
      return {1, 0};
    if (b > 0)
      part.begin = std::max(part.begin, Rational(-a / b));
    if (b < 0)
      part.end = std::min(part.end, Rational(-a / b));
  }
  return part;
}

bool face(const Point& e, const Point& f) {
  static const Wide cos10 = cos(boost::math::constants::pi<Wide>() / 18);
  return Wide(dot(e, f)) <= -cos10 * sqrt(Wide(Rational(dot(e, e) * dot(f, f))));
}

/// What one side of a neighbour would cover, and the conditions of the rule.
struct Candidate {
  Cover cover;
  Rational of_stretch, of_interval;
  std::array<bool, 5> holds{};
};
const std::array<std::string, 5> conditions{"face", "touch", "gap", "reach", "inside"};

/// All that the rule asks about a scene. Conditions can then be left out, so that a
/// test can count the answers that depend on each of them.
class Oracle {
 public:
  explicit Oracle(const Scene& scene) {
    const Shape own(scene.own), other(scene.other);
    const Segment g = own.side(scene.side);
    const Point e = g.along();
    const Rational length2 = dot(e, e);
    const Range interval = part_inside(g, other);
    interval_ = interval.length();
    if (interval_ == 0)
      return;
    const Range stretch =
        scene.at_start ? Range{0, interval.end} : Range{interval.begin, 1};
    stretch_ = stretch.length();
    const Rational h2 = stretch_ * stretch_ * length2;
    for (std::size_t n = 0; n < scene.neighbours.size(); ++n) {
      const Shape neighbour(scene.neighbours[n]);
      std::vector<Depth> of_own, of_neighbour;
      for (int i = 0; i < own.size(); ++i)
        of_own.push_back(depth(own.side(i), neighbour));
      for (int i = 0; i < neighbour.size(); ++i)
        of_neighbour.push_back(depth(neighbour.side(i), own));
      for (int i = 0; i < neighbour.size(); ++i) {
        const Segment f = neighbour.side(i);
        const Rational t0 = dot(f.start - g.start, e) / length2;
        const Rational t1 = dot(f.end - g.start, e) / length2;
        const Range covered = stretch.common({std::min(t0, t1), std::max(t0, t1)});
        if (covered.length() == 0)
          continue;
        Candidate c;
        c.cover = {static_cast<int>(n), i};
        c.of_stretch = covered.length();
        c.of_interval = covered.common(interval).length();
        c.holds[0] = face(e, f.along());
        c.holds[1] = touches(of_own, scene.side, of_neighbour, i);
        // The line at right angles to g through the middle meets f where s is.
        const Rational middle = (covered.begin + covered.end) / 2;
        const Rational s = (middle - t0) / (t1 - t0);
        const Point at_g(g.start.x + middle * e.x, g.start.y + middle * e.y);
        const Point at_f(f.start.x + s * f.along().x, f.start.y + s * f.along().y);
        const Rational gap = cross(e, at_f - at_g);  // times the length of g
        c.holds[2] = gap <= stretch_ * length2;
        gap_ties += gap == stretch_ * length2;
        const Depth reach = depth(f, other);
        const Rational reach2 = reach.area * abs(reach.area),
                       limit = h2 * reach.length2;
        c.holds[3] = reach2 >= limit;
        reach_ties += reach2 == limit;
        c.holds[4] = part_inside(f, other).length() > 0 ||
                     (gap <= 0 && -gap <= stretch_ * length2);
        overlap_ties += -gap == stretch_ * length2;
        candidates_.push_back(std::move(c));
      }
    }
  }

  /// The answer without one of the conditions (-1: with all). 5 leaves out that half of
  /// the stretch is covered, 6 that half of the interval is.
  Cover answer(int left_out = -1) const {
    if (interval_ == 0)
      return {};
    Rational of_stretch = 0, of_interval = 0, longest = 0;
    Cover best;
    for (const Candidate& c : candidates_) {
      bool covers = true;
      for (int i = 0; i < 5; ++i)
        covers = covers && (i == left_out || c.holds[static_cast<std::size_t>(i)]);
      if (!covers)
        continue;
      of_stretch += c.of_stretch, of_interval += c.of_interval;
      if (c.of_stretch > longest)
        best = c.cover, longest = c.of_stretch;
    }
    const bool enough = 2 * of_stretch >= stretch_ || left_out == 5;
    const bool inside = 2 * of_interval >= interval_ || left_out == 6;
    return enough && inside ? best : Cover{};
  }

  /// Adds up what kind of scene this was.
  void count(std::map<std::string, int>& counts) const {
    const Cover found = answer();
    ++counts[found ? "covered" : interval_ == 0 ? "no interval" : "not covered"];
    for (int i = 0; i < 7; ++i)
      if (const Cover without = answer(i);
          without.neighbour != found.neighbour || without.side != found.side)
        ++counts[i == 5   ? "stretch"
                 : i == 6 ? "interval"
                          : conditions[static_cast<std::size_t>(i)]];
    counts["gap equals h"] += gap_ties;
    counts["overlap equals h"] += overlap_ties;
    counts["reach equals h"] += reach_ties;
    Rational of_stretch = 0, of_interval = 0, longest = 0;
    int sides = 0, equals = 0;
    for (const Candidate& c : candidates_) {
      if (std::count(c.holds.begin(), c.holds.end(), true) < 5)
        continue;
      ++sides;
      of_stretch += c.of_stretch, of_interval += c.of_interval;
      equals += c.of_stretch == longest;
      if (c.of_stretch > longest)
        longest = c.of_stretch, equals = 0;
    }
    counts["several cover"] += sides > 1 && found;
    counts["equal rivals"] += equals > 0 && found;
    counts["half of the stretch"] += sides > 0 && 2 * of_stretch == stretch_;
    counts["half of the interval"] += sides > 0 && 2 * of_interval == interval_;
  }

 private:
  /// No other side is less deep than both of the two.
  static bool touches(const std::vector<Depth>& own, int g,
                      const std::vector<Depth>& neighbour, int f) {
    const Depth &of_g = own[static_cast<std::size_t>(g)],
                &of_f = neighbour[static_cast<std::size_t>(f)];
    for (const auto* depths : {&own, &neighbour})
      for (const Depth& d : *depths)
        if (d < of_g && d < of_f)
          return false;
    return true;
  }

  Rational interval_ = 0, stretch_ = 0;
  std::vector<Candidate> candidates_;
  int gap_ties = 0, overlap_ties = 0, reach_ties = 0;
};

// The scenes

/// The corners of the convex hull, clockwise, without straight corners.
Polygon hull(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  };
  std::sort(points.begin(), points.end(), before);
  Polygon chain;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = chain.size();
    for (const Vec2& p : points) {
      while (chain.size() >= first + 2 &&
             geometry::cross(chain.back() - chain[chain.size() - 2],
                             p - chain.back()) >= 0)
        chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

Polygon box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}};
}

/// Half-integer between a and b.
double half(Random& random, int a, int b) { return 0.5 * random.whole(2 * a, 2 * b); }

/// Bricks around the top of a brick, and a block that enters the joint between them:
/// all on half-integers. Side 0 of the own brick runs from (0, 0) to (length, 0).
Scene bricks(Random& random) {
  Scene s;
  const double length = half(random, 1, 4), height = half(random, 1, 3);
  s.own = {{0, 0}, {length, 0}, {length, -height}, {0, -height}};
  if (random.whole(0, 3) == 0)
    s.own.insert(s.own.begin() + 1, Vec2(0.5 * length, 0));  // a straight corner
  s.at_start = random.coin();
  const double joint = s.at_start ? 0 : length;
  for (int n = random.whole(1, 3); n > 0; --n) {
    const double gap = random.whole(0, 2) ? 0 : half(random, -1, 3);
    const double x = half(random, -1, 3), top = gap + half(random, 1, 3);
    Polygon brick = box(x, gap, x + half(random, 1, 4), top);
    if (random.whole(0, 3) == 0)
      brick[1].x() += 0.5;  // no rectangle any more
    const auto first = brick.begin() + random.whole(0, 3);
    std::rotate(brick.begin(), first, brick.end());
    s.neighbours.push_back(brick);
  }
  do {
    std::vector<Vec2> points;
    for (int n = random.whole(3, 5); n > 0; --n)
      points.emplace_back(joint + half(random, -3, 3), half(random, -3, 4));
    s.other = random.whole(0, 2) ? hull(points)
                                 : box(std::min(points[0].x(), points[1].x()) - 0.5,
                                       std::min(points[0].y(), points[1].y()) - 0.5,
                                       points[0].x() + 0.5, points[0].y() + 0.5);
    if (s.other.size() >= 3 &&
        geometry::cross(s.other[1] - s.other[0], s.other[2] - s.other[1]) >= 0)
      s.other.clear();
  } while (s.other.size() < 3);
  return s;
}

/// Random polygons around a joint, so that most conditions are open.
Scene random_scene(Random& random) {
  Scene s;
  const double length = random.uniform(0.5, 4);
  s.own = {{0, 0}, {length, 0}, {random.uniform(0, length), -random.uniform(0.5, 3)}};
  s.at_start = random.coin();
  const double joint = s.at_start ? 0 : length;
  for (int n = random.whole(1, 3); n > 0; --n) {
    const double gap = random.uniform(-0.3, 0.6);
    const double x0 = random.uniform(-1, 2), x1 = x0 + random.uniform(0.5, 4);
    const double slope = random.uniform(-0.25, 0.25);
    s.neighbours.push_back(
        hull({{x0, gap},
              {x1, gap + slope * (x1 - x0)},
              {random.uniform(x0, x1), gap + random.uniform(1, 3)}}));
  }
  do {
    std::vector<Vec2> points;
    for (int n = random.whole(3, 6); n > 0; --n)
      points.push_back(Vec2(joint, 0.5) + random.vector(2.5));
    s.other = hull(points);
  } while (s.other.size() < 3);
  return s;
}

void turn(Scene& s, double cosine, double sine, const Vec2& shift) {
  s.transform([&](const Vec2& v) -> Vec2 {
    return shift + Vec2(cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y());
  });
}

/// The mirror image: each polygon runs the other way, and so does the side.
Scene mirrored(Scene s) {
  s.transform([](const Vec2& v) -> Vec2 { return {-v.x(), v.y()}; });
  const auto size = static_cast<int>(s.own.size());
  s.side = (2 * size - 2 - s.side) % size;
  s.at_start = !s.at_start;
  std::reverse(s.own.begin(), s.own.end());
  std::reverse(s.other.begin(), s.other.end());
  for (Polygon& neighbour : s.neighbours)
    std::reverse(neighbour.begin(), neighbour.end());
  return s;
}

Cover ask(const Scene& s) {
  const std::vector<Outline> neighbours(s.neighbours.begin(), s.neighbours.end());
  return covering({s.own, s.side, s.at_start}, s.other, neighbours);
}

std::string text(const Scene& s) {
  std::ostringstream out;
  out << std::hexfloat << "side " << s.side << " at start " << s.at_start;
  const auto print = [&](const char* name, const Polygon& polygon) {
    out << "\n" << name;
    for (const Vec2& corner : polygon)
      out << " (" << corner.x() << ", " << corner.y() << ")";
  };
  print("own", s.own), print("other", s.other);
  for (const Polygon& neighbour : s.neighbours)
    print("neighbour", neighbour);
  return out.str();
}

using Counts = std::map<std::string, int>;

void judge(const Scene& s, Counts& counts) {
  if (!s.is_proper())
    return;
  const auto before = exact::covering_calls();
  const Cover found = ask(s);
  counts["rationals"] += exact::covering_calls() > before;
  const Oracle oracle(s);
  oracle.count(counts);
  const Cover right = oracle.answer();
  ASSERT_TRUE(found.neighbour == right.neighbour && found.side == right.side)
      << "found " << found.neighbour << ", " << found.side << ", right "
      << right.neighbour << ", " << right.side << "\n"
      << text(s);
}

void require(const Counts& counts, const Counts& least) {
  for (const auto& [name, count] : least)
    EXPECT_GE(counts.contains(name) ? counts.at(name) : 0, count) << name;
  for (const auto& [name, count] : counts)
    testing::Test::RecordProperty(name, count);  // for the report of the run
}

// Half-integers, turned by Pythagorean angles and scaled by powers of two: every tie of
// the rule occurs exactly.
TEST(CoveredSide, DecidesTiesOfBricks) {
  Random random;
  Counts counts;
  constexpr std::array<std::pair<int, int>, 4> turns{
      {{1, 0}, {0, 1}, {4, 3}, {-5, 12}}};
  for (int n = 0; n < 24000; ++n) {
    Scene s = bricks(random);
    if (random.coin())
      s = mirrored(s);
    const auto [a, b] = turns[static_cast<std::size_t>(n) % 4];
    turn(s, a, b, Vec2(random.whole(-9, 9), random.whole(-9, 9)));
    const double scale = std::ldexp(1, random.whole(-40, 40));
    s.transform([&](const Vec2& v) -> Vec2 { return scale * v; });
    ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << n;
  }
  require(counts, {{"covered", 4000},
                   {"not covered", 4000},
                   {"no interval", 4000},
                   {"several cover", 1500},
                   {"equal rivals", 500},
                   {"gap equals h", 1000},
                   {"overlap equals h", 50},
                   {"reach equals h", 700},
                   {"half of the stretch", 200},
                   {"half of the interval", 200},
                   {"face", 700},
                   {"gap", 250},
                   {"reach", 900},
                   {"inside", 30},
                   {"stretch", 60},
                   {"interval", 30},
                   {"rationals", 500}});
}

// The same bricks turned by any angle and moved away: rounding decides the ties.
TEST(CoveredSide, DecidesTurnedAndMovedBricks) {
  Random random;
  Counts counts;
  for (int n = 0; n < 10000; ++n) {
    Scene s = bricks(random);
    const double angle = random.uniform(0, 6.3);
    turn(s, std::cos(angle), std::sin(angle),
         random.vector(std::pow(10.0, random.whole(0, 9))));
    ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << n;
  }
  require(counts, {{"covered", 1500},
                   {"not covered", 2000},
                   {"several cover", 500},
                   {"touch", 50},
                   {"reach", 350},
                   {"rationals", 350}});
}

TEST(CoveredSide, DecidesRandomPolygons) {
  Random random;
  Counts counts;
  for (int n = 0; n < 5000; ++n) {
    Scene s = random_scene(random);
    if (n % 2)
      s = mirrored(s);
    ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << n;
  }
  require(counts,
          {{"covered", 1000}, {"not covered", 1500}, {"face", 600}, {"gap", 60}});
}

// A wedge above the side opens by ten degrees but for less than any rounding could
// tell. Everything else about it holds, so that the answer is whether the two sides
// face.
TEST(CoveredSide, DecidesSidesNextToTenDegrees) {
  Random random;
  Counts counts;
  for (const auto& [p, q] : fractions_near_tan10(0x1p44))
    for (const auto& [a, b] : {std::pair(1, 0), std::pair(4, 3), std::pair(-5, 12)})
      for (const bool mirror : {false, true}) {
        const double scale = std::ldexp(1, 2 - std::ilogb(q));
        Scene s;
        s.own = {{0, 0}, {4, 0}, {4, -3}, {0, -3}};
        s.other = box(-1, -1, 2, 8);
        s.neighbours = {{{0, 0}, {0, 6}, {scale * q, scale * p}}};
        if (mirror)
          s = mirrored(s);
        turn(s, a, b, {0, 0});
        ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << p << '/' << q;
      }
  require(counts, {{"covered", 80}, {"face", 80}, {"rationals", 40}});
}

// Coordinates from 1e-150 to 1e150 and beyond, alike and mixed. Mixed ones leave
// polygons that are not convex, for which the rule still has one answer.
TEST(CoveredSide, DecidesAnyMagnitude) {
  Random random;
  Counts counts;
  for (int n = 0; n < 1200; ++n) {
    Scene s = n % 2 ? bricks(random) : random_scene(random);
    const double angle = random.uniform(0, 6.3);
    turn(s, std::cos(angle), std::sin(angle), random.vector(1));
    const int most = n % 8 < 4 ? 500 : 1020;
    const double size = std::ldexp(1, random.whole(-most, most));
    s.transform([&](const Vec2& v) -> Vec2 { return size * v; });
    if (n % 4 == 3)
      s.transform([&](const Vec2& v) -> Vec2 {
        return v * std::ldexp(1, random.whole(-most, most));
      });
    ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << n;
  }
  require(counts, {{"covered", 150}, {"not covered", 250}, {"rationals", 350}});
}

// The first side covers a third of the stretch and the last one a half. Whether the one
// between them covers all of it is a tie, which intervals leave open.
TEST(CoveredSide, WeighsALaterSideAgainstAnOpenOne) {
  Scene s;
  s.own = {{0, 0}, {6, 0}, {6, -3}, {0, -3}};
  s.other = box(-1, -1, 5, 10);
  s.neighbours = {box(0, 0, 2, 3), box(0, 5, 6, 8), box(2, 0, 5, 3)};
  const auto before = exact::covering_calls();
  EXPECT_EQ(ask(s).neighbour, 1);
  EXPECT_GT(exact::covering_calls(), before) << "the case is too easy";
}

// The quick question

/// Whether the quick question is sure that nothing covers the side.
bool is_surely_uncovered(const Scene& s, double room) {
  UncoveredSide side({s.own, s.side, s.at_start}, s.other, room, room);
  for (const Polygon& neighbour : s.neighbours)
    side.add(neighbour);
  return side.is_sure();
}

// A polygon turned by almost ten degrees overlaps the side deeply. Across the side it
// is deeper than below another side of the own polygon, below its own side it is not:
// the two touch along these sides, and it covers.
TEST(UncoveredSide, MeasuresOverlapBelowTheCoveringSide) {
  Scene s;
  s.own = {{-0.238115, -0.039847}, {0, 0}, {5, 0}, {5, -5}, {-5, -5}};
  s.side = 1;
  s.at_start = true;
  s.other = {{-0.01, -1.2}, {-0.01, 0.1}, {0.02, 0.1}, {0.02, -1.2}};
  // Sides around a centre, the first one a little nearer than the others.
  const auto normal = [](int k) {
    const double angle = (-80.1 - 10.0 * k) * std::numbers::pi / 180.0;
    return Vec2(std::cos(angle), std::sin(angle));
  };
  const auto distance = [](int k) { return k % 36 == 0 ? 1.0 : 1.00001; };
  Polygon disc;
  for (int k = 0; k < 36; ++k) {
    Eigen::Matrix2d normals;
    normals << normal(k + 35).transpose(), normal(k).transpose();
    disc.push_back(s.own[0] + normals.inverse() * Vec2(distance(k + 35), distance(k)));
  }
  s.neighbours = {disc};
  EXPECT_TRUE(ask(s));
  EXPECT_FALSE(is_surely_uncovered(s, 0.0));
}

/// A wall of bricks beside the side that is nearly flush with it, turned a little, and
/// another block near the joint. Neighbours are much smaller or larger than the side,
/// or graze it.
Scene nearly_flush(Random& random) {
  Scene s;
  const double length = random.uniform(0.5, 3), height = random.uniform(0.5, 3);
  s.own = {{0, 0}, {length, 0}, {length, -height}, {0, -height}};
  s.at_start = random.coin();
  const double joint = s.at_start ? 0 : length, into = s.at_start ? 1 : -1;
  double x = joint - into * random.uniform(0, 0.5);
  for (int n = random.whole(1, 4); n > 0; --n) {
    const double width = std::pow(10.0, random.uniform(-2, 1));
    const double gap = std::pow(10.0, random.uniform(-14, -0.5)) * random.whole(-1, 1);
    const double tilt = std::pow(10.0, random.uniform(-14, -0.7)) * random.whole(-1, 1);
    const double next = x + into * width, top = gap + random.uniform(0.3, 4);
    const double low = std::min(x, next), high = std::max(x, next);
    s.neighbours.push_back({{low, gap},
                            {low, top},
                            {high, top + tilt * width},
                            {high, gap + tilt * width}});
    x = next + random.whole(-1, 1) * std::pow(10.0, random.uniform(-14, -1));
  }
  const double deep = std::pow(10.0, random.uniform(-9, 0.3));
  const double size = std::pow(10.0, random.uniform(-1, 0.7));
  const double beyond = joint + into * deep, top = random.uniform(-0.5, 1) * size;
  const double low = std::min(beyond, beyond - into * size),
               high = std::max(beyond, beyond - into * size);
  s.other = box(low, top - size, high, top);
  s.other[static_cast<std::size_t>(random.whole(0, 3))].x() +=
      random.uniform(-0.1, 0.1) * size;
  return s;
}

/// Each corner moved at random by up to half the room.
Scene moved(Random& random, Scene s, double room) {
  s.transform([&](const Vec2& v) -> Vec2 {
    const double angle = random.uniform(0, 6.3);
    const double by = 0.5 * room * (random.coin() ? 1.0 : random.uniform(0, 1));
    return v + (1 - 1e-9) * by * Vec2(std::cos(angle), std::sin(angle));
  });
  return s;
}

// "Certainly not covered" has to be right for every motion within the room, and has to
// be said in most scenes where it is.
TEST(CoveredSide, QuickQuestionIsNeverWrong) {
  Random random;
  const int scenes = std::getenv("BLOCKS_THOROUGH") != nullptr ? 1'000'000 : 12'000;
  int uncovered = 0, sure = 0, uncovered_with_room = 0, sure_with_room = 0;
  for (int n = 0; n < scenes; ++n) {
    Scene s = n % 3 == 0   ? bricks(random)
              : n % 3 == 1 ? random_scene(random)
                           : nearly_flush(random);
    if (random.coin())
      s = mirrored(s);
    const double angle = random.whole(0, 3) ? random.uniform(0, 6.3) : 0.0;
    turn(s, std::cos(angle), std::sin(angle),
         random.vector(random.coin() ? std::pow(10.0, random.whole(0, 9)) : 0.0));
    if (!s.is_proper())
      continue;
    const bool is_uncovered = !Oracle(s).answer();
    const bool is_sure = is_surely_uncovered(s, 0.0);
    uncovered += is_uncovered, sure += is_sure;
    ASSERT_TRUE(is_uncovered || !is_sure) << n << "\n" << text(s);
    const double room = std::pow(10.0, random.uniform(-12, -0.5));
    if (!is_surely_uncovered(s, room)) {
      uncovered_with_room += is_uncovered && room < 0.01;
      continue;
    }
    ASSERT_TRUE(is_sure) << n << "\n" << text(s);
    uncovered_with_room += room < 0.01, sure_with_room += room < 0.01;
    for (int k = 0; k < 3; ++k) {
      const Scene after = moved(random, s, room);
      ASSERT_TRUE(!after.is_proper() || !Oracle(after).answer())
          << n << ", room " << room << "\n"
          << text(s) << "\nmoved: " << text(after);
    }
  }
  RecordProperty("uncovered", uncovered);
  RecordProperty("sure", sure);
  RecordProperty("uncovered_with_room", uncovered_with_room);
  RecordProperty("sure_with_room", sure_with_room);
  EXPECT_GT(uncovered, scenes / 2);
  EXPECT_GT(scenes - uncovered, scenes / 8);
  EXPECT_GT(sure, 0.85 * uncovered) << "of " << uncovered;
  EXPECT_GT(sure_with_room, 0.8 * uncovered_with_room) << "of " << uncovered_with_room;
}

// Nothing is certain of sides that the room lets turn by any angle.
TEST(CoveredSide, QuickQuestionGivesUpOnSidesShorterThanTheRoom) {
  const auto box = [](double left, double bottom, double right, double top) {
    return Polygon{{left, bottom}, {left, top}, {right, top}, {right, bottom}};
  };
  // two slivers side by side, and a box on both of them
  const Polygon own = box(0, 0, 1, 0.1), beside = box(1, 0, 2, 0.1),
                other = box(0.5, 0.05, 1.5, 1);
  for (const double room : {0.0, 0.04, 0.051, 0.1, 1.0}) {
    UncoveredSide side({own, 2, true}, other, room, room);
    side.add(beside);
    EXPECT_FALSE(side.is_sure()) << room;
  }
}

// No size of coordinates makes the quick question sure of something wrong.
TEST(CoveredSide, QuickQuestionHoldsForAnyMagnitude) {
  Random random;
  int sure = 0;
  for (int n = 0; n < 3000; ++n) {
    Scene s = n % 3 == 0   ? bricks(random)
              : n % 3 == 1 ? random_scene(random)
                           : nearly_flush(random);
    const int most = n % 8 < 4 ? 440 : 1020;
    const double size = std::ldexp(1, random.whole(-most, most));
    s.transform([&](const Vec2& v) -> Vec2 { return size * v; });
    if (n % 4 == 3)
      s.transform([&](const Vec2& v) -> Vec2 {
        return v * std::ldexp(1, random.whole(-most, most));
      });
    if (!s.is_proper() || !is_surely_uncovered(s, 0.0))
      continue;
    ++sure;
    ASSERT_FALSE(Oracle(s).answer()) << n << "\n" << text(s);
  }
  EXPECT_GT(sure, 500);
}

// The order of the neighbours decides between equals only, and nothing else does.
TEST(CoveredSide, ObeysItsLaws) {
  Random random;
  int covered = 0;
  for (int n = 0; n < 10000; ++n) {
    const Scene s = n % 2 ? bricks(random) : random_scene(random);
    const Cover found = ask(s);
    covered += static_cast<bool>(found);
    ASSERT_EQ(ask(mirrored(s)).neighbour, found.neighbour) << text(s);
    Scene scaled = s;
    const double scale = std::ldexp(1, random.whole(-200, 200));
    scaled.transform([&](const Vec2& v) -> Vec2 { return scale * v; });
    ASSERT_EQ(ask(scaled).neighbour, found.neighbour) << text(s);
    ASSERT_EQ(ask(scaled).side, found.side) << text(s);
    Scene back = s;
    std::reverse(back.neighbours.begin(), back.neighbours.end());
    ASSERT_EQ(static_cast<bool>(ask(back)), static_cast<bool>(found)) << text(s);
    Scene alone = s;
    alone.neighbours.clear();
    ASSERT_FALSE(ask(alone)) << text(s);
  }
  EXPECT_GT(covered, 1000);
}

}  // namespace
}  // namespace blocks::geometry
