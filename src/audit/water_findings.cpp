#include "audit/water_findings.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

namespace blocks::audit {
namespace {

using Rational = boost::multiprecision::cpp_rational;

struct Place {
  Rational x, y;
};
using Outline = std::vector<Place>;

Rational dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }
Place exact(const Vec2& at) { return {Rational(at.x()), Rational(at.y())}; }

/// Returns the part of an outline where c + n.x >= 0. Parts of a block that is not
/// convex may be joined by seams of no area.
Outline clipped(const Outline& shape, const Rational& c, const Place& n) {
  Outline kept;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Place &a = shape[i], &b = shape[(i + 1) % shape.size()];
    const Rational at_a = c + dot(n, a), at_b = c + dot(n, b);
    if (at_a >= 0)
      kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) {
      const Rational t = at_a / (at_a - at_b);
      kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return kept;
}

/// Returns the area of a clockwise outline.
Rational area(const Outline& shape) {
  Rational twice = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Place &a = shape[i], &b = shape[(i + 1) % shape.size()];
    twice += b.x * a.y - a.x * b.y;
  }
  return twice / 2;
}

/// Returns the force of the table on an outline, divided by gamma.
Place exact_force(const Outline& shape, const WaterTable& table, const WaterNow& now) {
  const Place up = exact(table.up), across = {up.y, -up.x};
  const std::size_t points = table.place.size();
  const auto place = [&](std::size_t k) { return Rational(table.place[k]); };
  const auto level = [&](std::size_t k) {
    return Rational(now.level_at(table.place[k]));
  };
  Place sum = {0, 0};
  for (std::size_t k = 0; k <= points; ++k) {
    const std::size_t low = k == 0 ? 0 : k - 1, high = k == points ? points - 1 : k;
    Rational slope = 0;
    if (low != high)
      slope = (level(high) - level(low)) / (place(high) - place(low));
    Outline part = shape;
    if (k > 0)
      part = clipped(part, -place(k - 1), across);
    if (k < points)
      part = clipped(part, place(k), {-across.x, -across.y});
    const Place gradient = {slope * across.x - up.x, slope * across.y - up.y};
    const Rational wet = area(clipped(part, level(low) - slope * place(low), gradient));
    sum.x -= wet * gradient.x;
    sum.y -= wet * gradient.y;
  }
  return sum;
}

}  // namespace

WaterError worst_water(const Moment& moment) {
  WaterError worst;
  const Blocks& blocks = moment.blocks;
  const WaterTable& table = moment.water.table;
  WaterNow now(moment.water, moment.time);
  if (!now.has_table())
    return worst;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b) || moment.water.has_own(blocks, b))
      continue;
    Outline shape;
    for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
      shape.push_back(exact(blocks.corner.col(c)));
    const Place wanted = exact_force(shape, table, now);
    const Vec2 found = now.on_block(blocks, b).force;
    const Rational gamma(table.gamma);
    const Vec2 difference(static_cast<double>(Rational(found.x()) - gamma * wanted.x),
                          static_cast<double>(Rational(found.y()) - gamma * wanted.y));
    const double share =
        difference.norm() / (table.gamma * static_cast<double>(area(shape)));
    if (worst.block < 0 || !(share <= worst.share))
      worst = {b, share};
  }
  return worst;
}

}  // namespace blocks::audit
