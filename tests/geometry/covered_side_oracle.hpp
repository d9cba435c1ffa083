// An oracle for covered sides on rationals of boost, written from
// docs/contact-rule.md#covered-sides. It shares nothing with the code that it judges.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "covered_side_scenes.hpp"

namespace blocks::geometry::covering_tests {

struct Point {
  Rational x, y;
  explicit Point(const Vec2& v) : x(v.x()), y(v.y()) {}
  Point(Rational a, Rational b) : x(std::move(a)), y(std::move(b)) {}
  friend Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y};
  }
};
inline Rational dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
inline Rational cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

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

/// A depth as twice the area below a side and the squared length of the side.
struct Depth {
  Rational area, length2;
  bool operator<(const Depth& b) const {
    return area * abs(area) * b.length2 < b.area * abs(b.area) * length2;
  }
};
inline Depth depth(const Segment& side, const Shape& other) {
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

/// Returns the part of a segment that lies in a convex polygon. The parameter runs from
/// 0 to 1 along the segment.
inline Range part_inside(const Segment& segment, const Shape& polygon) {
  Range part{0, 1};
  for (int k = 0; k < polygon.size(); ++k) {
    const Segment side = polygon.side(k);
    // Twice the area below the side at parameter t is a + b t.
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

/// Whether two directions are opposite to each other within ten degrees.
inline bool face(const Point& e, const Point& f) {
  static const Wide cos10 = cos(boost::math::constants::pi<Wide>() / 18);
  return Wide(dot(e, f)) <= -cos10 * sqrt(Wide(Rational(dot(e, e) * dot(f, f))));
}

/// A side of a neighbour that might cover, the lengths that it would cover, and which
/// conditions of the rule hold for it.
struct Candidate {
  Cover cover;
  Rational of_stretch, of_interval;
  std::array<bool, 5> holds{};
};
inline const std::array<std::string, 5> conditions{"face", "touch", "gap", "reach",
                                                   "inside"};

/// Evaluates the rule for a scene. A condition can be left out, so that a test can
/// count the answers that depend on it.
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
        // The normal of g through the middle meets f at parameter s.
        const Rational middle = (covered.begin + covered.end) / 2;
        const Rational s = (middle - t0) / (t1 - t0);
        const Point at_g(g.start.x + middle * e.x, g.start.y + middle * e.y);
        const Point at_f(f.start.x + s * f.along().x, f.start.y + s * f.along().y);
        const Rational gap =
            cross(e, at_f - at_g);  // The gap is multiplied by the length of g.
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

  /// Returns the answer without condition `left_out`, or with all conditions for -1.
  /// The values 5 and 6 leave out that half of the stretch or of the interval is
  /// covered.
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

  /// Counts the properties of the scene by name.
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
  /// Whether no other side is less deep than both side g and side f.
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

}  // namespace blocks::geometry::covering_tests
