// The fast answers about third polygons equal those of rationals: for polygons with
// common corners and flush sides, and for the same turned, scaled and moved by an ulp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "geometry/continuation.hpp"
#include "geometry/exact/continuation_questions.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

using exact::Rational;

/// Makes triples of convex polygons.
class Polygons {
 public:
  /// Chooses a map of the plane for the next polygons.
  void next_frame() {
    const int turns[][2] = {{1, 0}, {0, -1}, {3, 4}, {-24, 7}};
    const auto* const turn = turns[below(4)];
    x_ = turn[0], y_ = turn[1];
    if (below(3) == 0) {  // a rotation that rounds
      const double angle = 1e-3 * below(6284);
      x_ = std::cos(angle), y_ = std::sin(angle);
    }
    const double scales[] = {1.0, 1.0, 0x1p-20, 0x1p40, 0x1p-330, 0x1p300, 0x1p510};
    scale_ = scales[below(7)];
    const double shifts[] = {0.0, 0.0, 12.34, 1e6};
    shift_ = shifts[below(4)];
    moves_ = below(3) == 0;
  }
  /// A clockwise convex polygon of points of a small grid, or a rectangle.
  Polygon next() {
    Polygon grid;
    do {
      grid = below(2) == 0 ? rectangle() : hull();
    } while (grid.size() < 3);
    for (Vec2& p : grid)
      p = map(p);
    return grid;
  }
  int below(int count) { return static_cast<int>(random_() % unsigned(count)); }

 private:
  double coordinate() { return static_cast<double>(below(6)); }
  Vec2 map(const Vec2& p) {
    const Vec2 turned(x_ * p.x() - y_ * p.y(), y_ * p.x() + x_ * p.y());
    return {nudged(scale_ * (turned.x() + shift_)),
            nudged(scale_ * (turned.y() - shift_))};
  }
  double nudged(double x) {
    return moves_ && below(2) == 0 ? std::nextafter(x, below(2) == 0 ? -1e300 : 1e300)
                                   : x;
  }
  Polygon rectangle() {
    const double x = coordinate(), y = coordinate(), w = 1 + below(4), h = 1 + below(4);
    return {{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}};
  }
  /// The corners of the convex hull of five points of the grid.
  Polygon hull() {
    Polygon points;
    for (int i = 0; i < 5; ++i)
      points.push_back({coordinate(), coordinate()});
    const auto before = [](const Vec2& a, const Vec2& b) {
      return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    Polygon found;
    const auto add_chain = [&](const auto& from, const auto& to) {
      const std::size_t first = found.size();
      for (auto p = from; p != to; ++p) {
        while (found.size() >= first + 2 &&
               cross(Vec2(found.back() - found[found.size() - 2]),
                     Vec2(*p - found.back())) >= 0.0)
          found.pop_back();
        found.push_back(*p);
      }
      found.pop_back();
    };
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    return found;
  }

  std::mt19937 random_{7};
  double x_ = 1, y_ = 0, scale_ = 1, shift_ = 0;
  bool moves_ = false;
};

/// Twice the area below a side, exactly.
Rational area(Outline polygon, int side, const Vec2& corner) {
  return continuation::Side<Rational>(polygon, side)
      .area(continuation::Arrow<Rational>(corner));
}

/// Returns the axis of a side, with a facing side if the one at the corner runs against
/// the side and `may_face` is true.
PolygonAxis axis_of(Outline own, int side, Outline other, bool may_face) {
  PolygonAxis axis{own, side, other, 0, -1};
  for (int k = 1; k < static_cast<int>(other.size()); ++k)
    if (area(own, side, other[static_cast<std::size_t>(k)]) >
        area(own, side, other[static_cast<std::size_t>(axis.corner)]))
      axis.corner = k;
  const continuation::Side<Rational> e(own, side), f(other, axis.corner);
  if (may_face && dot(e.along, f.along) < 0)
    axis.facing = axis.corner;
  return axis;
}

/// Three polygons, and the axis of a side of the first one.
struct Case {
  Polygon own, other, third;
  int side;
  bool may_face;
};

Case next_case(Polygons& make) {
  make.next_frame();
  Case c{make.next(), make.next(), make.next(), 0, make.below(2) == 0};
  c.side = make.below(static_cast<int>(c.own.size()));
  return c;
}

constexpr int questions = 7;
struct Answers {
  bool fast, exact;
};

/// Asks one of the questions. There is no answer if the other polygon is outside the
/// side.
std::optional<Answers> answers(int question, const Case& at) {
  using Question = continuation::AxisQuestion<Rational>;
  if (question == 0)
    return Answers{crosses(at.own, at.side, at.third),
                   continuation::crosses<Rational>(at.own, at.side, at.third)};
  const PolygonAxis axis = axis_of(at.own, at.side, at.other, at.may_face);
  const Vec2 &p1 = sides::start_of(at.own, at.side),
             &p2 = sides::end_of(at.own, at.side),
             &c = at.other[static_cast<std::size_t>(axis.corner)];
  if (area(at.own, at.side, c) <= 0)
    return std::nullopt;
  const Outline other(at.other), third(at.third);
  switch (question) {
  case 1:
    return Answers{
        exceeds_separating_shift(c, p1, p2, other, third),
        continuation::exceeds_separating_shift<Rational>(c, p1, p2, other, third)};
  case 2:
    return Answers{
        exceeds_common_region(c, p1, p2, other, third),
        continuation::exceeds_common_region<Rational>(c, p1, p2, other, third)};
  case 3:
    return Answers{is_in_notch_of(axis, third), Question(axis).is_in_notch_of(third)};
  case 4:
    return Answers{is_at_joint_with(c, p1, p2, axis, third),
                   continuation::is_at_joint<Rational>(c, p1, p2, axis, third)};
  default:
    const Continues which = question == 5 ? Continues::own : Continues::other;
    return Answers{is_hidden_by(axis, third, which),
                   Question(axis).is_hidden_by(third, which)};
  }
}

TEST(ContinuationAnswers, EqualThoseOfRationals) {
  Polygons make;
  int count[questions][2] = {};
  for (int run = 0; run < 8000; ++run) {
    const Case at = next_case(make);
    for (int question = 0; question < questions; ++question)
      if (const auto found = answers(question, at)) {
        ASSERT_EQ(found->fast, found->exact)
            << "question " << question << " in " << run;
        ++count[question][found->exact];
      }
  }
  for (int question = 0; question < questions; ++question)
    for (const int of_answer : count[question])
      EXPECT_GT(of_answer, 20) << "question " << question;
}

// The third polygon moves to where the answer changes, down to the last bit of its
// coordinates.
TEST(ContinuationAnswers, EqualThoseOfRationalsWhereTheyChange) {
  Polygons make;
  int changes[questions] = {};
  for (int run = 0; run < 2000; ++run) {
    const Case from = next_case(make);
    const Vec2 way = make.next().front() - from.third.front();
    const int question = run % questions;
    const auto ask = [&](double part) {
      Case at = from;
      for (Vec2& corner : at.third)
        corner += part * way;
      return answers(question, at);
    };
    const auto first = ask(0.0), last = ask(1.0);
    if (!first || first->exact == last->exact)
      continue;
    ++changes[question];
    double low = 0.0, high = 1.0;
    for (int step = 0; step < 56; ++step) {
      const double middle = 0.5 * (low + high);
      const auto found = ask(middle);
      ASSERT_EQ(found->fast, found->exact) << "question " << question << " in " << run;
      (found->exact == first->exact ? low : high) = middle;
    }
  }
  for (const int count : changes)
    EXPECT_GT(count, 5) << "question " << &count - changes;
}

}  // namespace
}  // namespace blocks::geometry
