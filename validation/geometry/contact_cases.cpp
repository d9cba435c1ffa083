#include "validation/geometry/contact_cases.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/contact_predicates.hpp"

namespace blocks::validation {
namespace {

Vec2 turned(const Vec2& v, double cosine, double sine) {
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

void turn_and_move(ContactCase& k, double angle, const Vec2& origin) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  k.transform([&](const Vec2& v) -> Vec2 { return origin + turned(v, cosine, sine); });
}

constexpr std::array<std::pair<int, int>, 6> pythagorean{
    {{4, 3}, {12, 5}, {21, 20}, {15, 8}, {56, 33}, {72, 65}}};

/// Returns the first proper case that `draw_case` makes.
template <class DrawCase>
ContactCase first_proper(std::uint64_t family, std::uint64_t number,
                         DrawCase&& draw_case) {
  Draw draw(family, number);
  ContactCase k;
  do
    k = draw_case(draw);
  while (!k.proper());
  return k;
}

ContactCase random_case(std::uint64_t number) {
  return first_proper(0, number, [](Draw& draw) { return anywhere(draw, 1); });
}

ContactCase flush_brick(std::uint64_t number) {
  return first_proper(1, number, [](Draw& draw) {
    ContactCase k = brick(draw);
    const double scale = std::ldexp(1, draw.whole(-40, 40));
    k.transform([&](const Vec2& v) -> Vec2 { return scale * v; });
    return k;
  });
}

/// A Pythagorean angle keeps whole numbers whole, so corners are exactly on the line,
/// at the ends, or equally deep.
ContactCase pythagorean_brick(std::uint64_t number) {
  return first_proper(2, number, [number](Draw& draw) {
    const auto [a, b] = pythagorean[number % pythagorean.size()];
    const double scale = std::ldexp(1, draw.whole(-40, 40));
    const Vec2 shift(draw.whole(-1000, 1000), draw.whole(-1000, 1000));
    ContactCase k = brick(draw);
    k.transform([&, a = a, b = b](const Vec2& v) -> Vec2 {
      return scale * (turned(v, a, b) + shift);
    });
    if (draw.whole(0, 7) == 0)
      k.c = k.centroid + (k.p2 - k.p1);
    return k;
  });
}

ContactCase turned_brick(std::uint64_t number) {
  return first_proper(3, number, [](Draw& draw) {
    ContactCase k = brick(draw);
    turn_and_move(k, draw.uniform(0, 6.3), {0, 0});
    return k;
  });
}

ContactCase far_brick(std::uint64_t number) {
  return first_proper(4, number, [](Draw& draw) {
    ContactCase k = brick(draw);
    const double offset = std::pow(10.0, draw.whole(0, 15));
    turn_and_move(k, draw.coin() ? 0 : draw.uniform(0, 6.3), draw.vector(offset));
    return k;
  });
}

/// Puts the corner up to three doubles away from a limit: the line, the slack, an end,
/// the depth of the centroid, or a bisector of two edges.
ContactCase next_to_limit(std::uint64_t number) {
  return first_proper(5, number, [](Draw& draw) {
    ContactCase k = anywhere(draw, 1);
    if (draw.coin())
      k.q1 = k.p2;
    const Vec2 e = k.p2 - k.p1, left(-e.y(), e.x()), f = k.q2 - k.q1;
    const double s = draw.uniform(0, 1), slack = geometry::contact_slack;
    const std::array<Vec2, 8> limits{
        k.p1 + s * e,
        k.p1 + s * e + slack * left,
        k.p1 - slack * e + s * left,
        k.p2 + slack * e + s * left,
        k.centroid + s * e,
        k.p2 + s * (e.normalized() + f.normalized()),
        k.p2 + s * (e.normalized() - f.normalized()),
        s < 0.5 ? k.p1 : k.p2,
    };
    k.c = draw.nudge(limits[draw.bits() % limits.size()], 3);
    return k;
  });
}

/// Returns whole numbers p, q < 2^46 with p / q converging to tan 10 degrees from both
/// sides: the convergents and semiconvergents of its continued fraction.
std::vector<Vec2> fractions_near_tan10() {
  using Wide = boost::multiprecision::cpp_bin_float_100;
  using Whole = boost::multiprecision::cpp_int;
  Wide x = tan(boost::math::constants::pi<Wide>() / 18);
  Whole p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  std::vector<Vec2> found;
  for (;;) {
    const auto term = floor(x).convert_to<Whole>();
    for (Whole part = 1; part <= term; ++part) {
      const Whole p = part * p1 + p0, q = part * q1 + q0;
      if (q > Whole(0x1p46))
        return found;
      found.emplace_back(p.convert_to<double>(), q.convert_to<double>());
    }
    const Whole p = term * p1 + p0, q = term * q1 + q0;
    p0 = std::exchange(p1, p);
    q0 = std::exchange(q1, q);
    x = 1 / (x - Wide(term));
  }
}

ContactCase near_ten_degrees(std::uint64_t number) {
  static const std::vector<Vec2> fractions = fractions_near_tan10();
  return first_proper(6, number, [](Draw& draw) {
    const Vec2& f = fractions[draw.bits() % fractions.size()];
    const auto [a, b] = pythagorean[draw.bits() % 3];
    ContactCase k = anywhere(draw, 1);
    const double tangent = std::ldexp(1, draw.whole(-60, 60));
    const double edge = std::ldexp(draw.whole(1, 9), draw.whole(-60, 60));
    k.c = k.p1 = {0, 0};
    k.p2 = edge * Vec2(a, b);
    // The tangent points 10 degrees into the block, towards p2 or towards p1.
    const double way = draw.coin() ? 1 : -1;
    k.neighbour = tangent * turned({way * f.y(), -f.x()}, a, b);
    if (draw.whole(0, 3) == 0)
      k.neighbour = draw.nudge(k.neighbour, 1);
    return k;
  });
}

/// Points of very different magnitude on a line through the origin. No difference is a
/// double, and the last bit of the smallest point decides.
ContactCase inexact_differences(std::uint64_t number) {
  return first_proper(7, number, [](Draw& draw) {
    const Vec2 along(draw.whole(1, 1 << 26), draw.whole(1, 1 << 26));
    ContactCase k = anywhere(draw, 1);
    k.c = along * draw.whole(1, 9);
    k.p1 = along * std::ldexp(draw.whole(1, 9), draw.whole(-64, -40));
    k.p2 = along * -draw.whole(1, 9);
    k.centroid = draw.nudge(along * std::ldexp(1, draw.whole(-64, -40)), 1);
    if (draw.whole(0, 2))
      k.p1 = draw.nudge(k.p1, 2);
    if (draw.coin())
      std::swap(k.c, k.p1);
    return k;
  });
}

ContactCase subnormal(std::uint64_t number) {
  return first_proper(8, number, [](Draw& draw) {
    ContactCase k = draw.coin() ? brick(draw) : anywhere(draw, 1);
    const double size = std::ldexp(1, draw.whole(-1074, -900));
    const Vec2 turn = draw.coin() ? Vec2(1, 0) : draw.vector(1);
    k.transform(
        [&](const Vec2& v) -> Vec2 { return size * turned(v, turn.x(), turn.y()); });
    return k;
  });
}

/// Scales a case by a power of two between the smallest subnormal and overflow: all
/// points by the same power, or each by its own.
ContactCase any_magnitude(std::uint64_t number) {
  return first_proper(9, number, [](Draw& draw) {
    ContactCase k = draw.coin() ? brick(draw) : anywhere(draw, 1);
    const bool mixed = draw.coin();
    const double size = std::ldexp(1, draw.whole(-1074, 1023));
    k.transform([&](const Vec2& v) -> Vec2 {
      return v * (mixed ? std::ldexp(1, draw.whole(-1074, 1023)) : size);
    });
    return k;
  });
}

/// Factors for which x1 x2 - y1 y2 is zero up to a few units in the last place. They
/// are multiples of 2^-52 and the products stay below 1.5. Three units therefore exceed
/// 2u times the sum of the products, and the rounding errors can add up to more.
struct Factors {
  double x1, x2, y1, y2;

  explicit Factors(Draw& draw) {
    x1 = draw.uniform(1.15, 1.22), x2 = draw.uniform(1.15, 1.22);
    y1 = draw.uniform(1.1, 1.2);
    y2 = draw.nudge(x1 * x2 / y1, 4);
  }
};

/// Returns nearly half a unit in the last place of a number between 1 and 2: the
/// largest rounding error of a difference.
double lost(Draw& draw) { return std::ldexp(draw.uniform(0.98, 1.0), -53); }

/// Sets a case near the error bound of `overlap`, or of `near_or_inside` with a slack.
/// Both differences of one product round away from zero, and both of the other towards
/// it, or the reverse.
void overlap_near_bound(ContactCase& k, Draw& draw, bool slack) {
  const double sx = draw.coin() ? 1 : -1, sy = draw.coin() ? 1 : -1;
  const double way = draw.coin() ? 1 : -1;
  const Factors f(draw);
  k.c = {sx * f.x1, -sy * f.y2};
  k.p2 = {-sx * f.y1, sy * f.x2};
  if (slack)  // The slack is that of this edge.
    k.c.y() = draw.nudge(-sy *
                             (f.x1 * f.x2 + sx * sy * geometry::contact_slack *
                                                (f.y1 * f.y1 + f.x2 * f.x2)) /
                             f.y1,
                         4);
  k.p1.x() = sx * way * lost(draw);
  k.p1.y() = sy * way * lost(draw);
  k.q1 = k.c;  // The depth below edge q is 0, so compare_depths has the same sign.
}

/// Sets a case near the error bound of the first end of the edge. The edge is short, so
/// the corner is far from that end.
void end_near_bound(ContactCase& k, Draw& draw) {
  const double s = std::ldexp(1, -draw.whole(5, 8));  // length of the edge
  const double sx = draw.coin() ? 1 : -1, sy = draw.coin() ? 1 : -1;
  const double way = draw.coin() ? 1 : -1;
  Factors f(draw);
  f.y1 = draw.nudge(
      (f.x1 * f.x2 + geometry::contact_slack * s * (f.x2 * f.x2 + f.y2 * f.y2)) / f.y2,
      4);
  // The coarse part rounds the differences of the corner, the fine part those of the
  // edge.
  const Vec2 coarse = std::ldexp(1 - 2 * s, -53) * Vec2(sx * way, -sy * way);
  const double x = s * lost(draw);
  const Vec2 fine(sx * way * x, sy * way * s * lost(draw));
  k.c = {sx * f.x1, sy * f.y1};
  k.p1 = coarse + fine;
  k.p2 = coarse + Vec2(sx * f.x2 * s, -sy * f.y2 * s);
}

/// Sets a case near the error bound of `turn`: the corner is as deep as the centroid,
/// which is far away along a short edge.
void turn_near_bound(ContactCase& k, Draw& draw) {
  const double s = std::ldexp(1, -draw.whole(5, 8));  // length of the edge
  const double sx = draw.coin() ? 1 : -1, sy = draw.coin() ? 1 : -1;
  const double across = draw.coin() ? 1 : -1, way = draw.coin() ? 1 : -1;
  const Factors f(draw);
  const double along = sx * sy * across;
  k.p2 = {along * f.y2 * s, sy * f.x2 * s};
  k.p1.x() = -along * way * s * lost(draw);
  k.p1.y() = sy * way * s * lost(draw);
  const Vec2 middle = 0.5 * k.p2 + 0.1 * Vec2(k.p2.y(), -k.p2.x());
  const Vec2 grid(std::ldexp(std::round(std::ldexp(middle.x(), 52)), -52),
                  std::ldexp(std::round(std::ldexp(middle.y(), 52)), -52));
  k.centroid = grid - Vec2(sx * f.x1, across * f.y1);
  k.c.x() = grid.x() - sx * way * lost(draw);
  k.c.y() = grid.y() + across * way * lost(draw);
}

/// Sets a tangent at -10 degrees such that every difference has the largest rounding
/// error.
void tangent_near_bound(ContactCase& k, Draw& draw) {
  constexpr double degrees = 0.017453292519943295;
  const double angle = (draw.coin() ? -10 : -170) * degrees;
  const auto sign = [&] { return draw.coin() ? 1.0 : -1.0; };
  k.p2.x() = sign() * draw.uniform(1, 1.3);
  k.p2.y() = sign() * draw.uniform(1, 1.3);
  k.neighbour = draw.nudge(turned(k.p2, std::cos(angle), std::sin(angle)), 3);
  for (Vec2* v : {&k.p1, &k.c})
    for (int axis : {0, 1})
      (*v)[axis] = sign() * lost(draw);
}

/// Inputs whose error is near the bound of a filter. They expose a bound that is too
/// small by a third; docs/predicates.md says for which bounds this is possible.
ContactCase near_the_bound(std::uint64_t number) {
  return first_proper(10, number, [number](Draw& draw) {
    ContactCase k = anywhere(draw, 1);
    switch (number % 5) {
    case 0:
    case 1:
      overlap_near_bound(k, draw, number % 5 == 1);
      break;
    case 2:
      end_near_bound(k, draw);
      break;
    case 3:
      turn_near_bound(k, draw);
      break;
    default:
      tangent_near_bound(k, draw);
    }
    const double scale = std::ldexp(1, draw.whole(-40, 40));
    k.transform([&](const Vec2& v) -> Vec2 { return scale * v; });
    return k;
  });
}

}  // namespace

const std::array<ContactFamily, contact_family_count>& contact_families() {
  static const std::array<ContactFamily, contact_family_count> all{{
      {"random", 15, random_case},
      {"bricks, flush", 10, flush_brick},
      {"bricks, turned by Pythagorean angles", 12, pythagorean_brick},
      {"bricks, turned by random angles", 12, turned_brick},
      {"bricks, moved away by 1 to 1e15", 14, far_brick},
      {"next to a limit", 14, next_to_limit},
      {"tangents next to -10 degrees", 10, near_ten_degrees},
      {"differences that are no doubles", 4, inexact_differences},
      {"errors next to the bounds", 5, near_the_bound},
      {"subnormal", 2, subnormal},
      {"any magnitude, alike or mixed", 2, any_magnitude},
  }};
  return all;
}

}  // namespace blocks::validation
