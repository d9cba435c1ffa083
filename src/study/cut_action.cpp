#include "study/cut_action.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "study/free_shift.hpp"

namespace blocks::study {
namespace {

constexpr double pi = std::numbers::pi;

Vec2 turned(const Vec2& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// Turns an outline about the origin, then shifts it.
Polygon moved(Polygon outline, double angle, const Vec2& by) {
  for (Vec2& p : outline)
    p = turned(p, angle) + by;
  return outline;
}

double log_between(Draws& draw, double low, double high) {
  return std::exp(draw.between(std::log(low), std::log(high)));
}

double angle_of(const Vec2& v) { return std::atan2(v.y(), v.x()); }

/// A polygon of 3 to 8 corners on an ellipse, about the origin.
Polygon draw_polygon(Draws& draw) {
  while (true) {
    const int corners = 3 + draw.below(6);
    const double flat = draw.below(3) == 0 ? draw.between(0.3, 1.0) : 1.0;
    std::vector<double> at;
    for (int i = 0; i < corners; ++i)
      at.push_back(draw.between(0.0, 2.0 * pi));
    std::sort(at.begin(), at.end(), std::greater<>());  // clockwise
    Polygon outline;
    for (const double angle : at)
      outline.emplace_back(0.5 * std::cos(angle), 0.5 * flat * std::sin(angle));
    if (narrowest_width(outline) > 0.1 && sharpest_angle(outline) > 12.0)
      return outline;
  }
}

Polygon box(double width, double height) {
  const double w = 0.5 * width, h = 0.5 * height;
  return {{-w, -h}, {-w, h}, {w, h}, {w, -h}};
}

Polygon draw_block(Draws& draw) {
  const int kind = draw.below(10);
  if (kind < 3)
    return box(1.0, draw.between(0.3, 1.0));
  if (kind < 5)
    return box(1.0, draw.between(0.06, 0.2));
  return draw_polygon(draw);
}

/// A regular polygon with a side at the bottom.
Polygon draw_roller(Draws& draw) {
  const int corners = 5 + draw.below(8);
  Polygon outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = -0.5 * pi - (i + 0.5) * 2.0 * pi / corners;
    outline.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle));
  }
  return outline;
}

/// A place on the surface, and the direction out of the domain there.
struct Target {
  Vec2 place, out;
};

Vec2 normal_of(const CutDomain& domain, int side) {
  const auto i = static_cast<std::size_t>(side);
  const Vec2 along = domain.outline[i + 1] - domain.outline[i];
  return Vec2(-along.y(), along.x()).normalized();
}

/// The mean of the normals of the sides of the surface that meet at a point.
Vec2 normal_at(const CutDomain& domain, const Vec2& point) {
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i + 1 < domain.surface; ++i) {
    const Vec2 a = domain.outline[static_cast<std::size_t>(i)];
    const Vec2 b = domain.outline[static_cast<std::size_t>(i) + 1];
    const double t = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0., 1.);
    if ((point - a - t * (b - a)).norm() < 1e-9)
      sum += normal_of(domain, i);
  }
  return sum.normalized();
}

/// Draws the end of a joint, an inner corner of the surface or any point of it.
Target draw_target(Draws& draw, const CutDomain& domain) {
  const int kind = draw.below(10);
  Vec2 place;
  const int side = draw.below(domain.surface - 1);
  const double part = draw();
  const auto corner = static_cast<std::size_t>(
      domain.surface > 2 ? 1 + draw.below(domain.surface - 2) : 0);
  const int end = draw.below(std::max(1, static_cast<int>(domain.ends.size())));
  if (kind < 5 && !domain.ends.empty()) {
    place = domain.ends[static_cast<std::size_t>(end)];
  } else if (kind < 8 && domain.surface > 2) {
    place = domain.outline[corner];
  } else {
    const auto i = static_cast<std::size_t>(side);
    place = (1.0 - part) * domain.outline[i] + part * domain.outline[i + 1];
    place.x() = std::clamp(place.x(), -2.0, 2.0);
    return {place, normal_of(domain, side)};
  }
  return {place, normal_at(domain, place)};
}

/// Shifts the block out of the domain, and beyond by the gap.
Polygon lifted(const Polygon& block, const Domain& domain, const Vec2& out,
               double gap) {
  return moved(block, 0.0, (free_shift(block, domain, out) + gap) * out);
}

/// Puts a corner of the block near the target, with any rotation.
Polygon aimed(Draws& draw, const Polygon& block, const Domain& domain,
              const Target& target, double overlap, double gap) {
  const double angle = draw.between(0.0, 2.0 * pi);
  const double side = draw.below(2) == 0 ? -1.0 : 1.0;
  const double distance = log_between(draw, 0.03, 30.0) * overlap;
  const double aside = draw.below(4) == 0 ? 0.0 : side * distance;
  const bool centred = draw.below(3) == 0;
  const Polygon there = moved(block, angle, {0, 0});
  // The corner that is lowest against the direction out of the domain.
  const Vec2 corner =
      *std::min_element(there.begin(), there.end(), [&](const Vec2& p, const Vec2& q) {
        return p.dot(target.out) < q.dot(target.out);
      });
  const Vec2 along(target.out.y(), -target.out.x());
  const Vec2 at = target.place + aside * along;
  return lifted(moved(there, 0.0, at - (centred ? Vec2(0, 0) : corner)), domain,
                target.out, gap);
}

/// A block with a side on a side of the surface, and the direction along the surface.
struct Flush {
  Polygon block;
  Vec2 along, out;
};

/// Puts side 0 of the block on a side of the surface. Its front is before a joint, an
/// end of the side or any point, at most `reach` away.
Flush lie_flush(Draws& draw, const Polygon& block, const CutDomain& cut,
                const Domain& domain, double reach) {
  int side = draw.below(cut.surface - 1);
  if (!cut.ends.empty() && draw.below(10) < 7)
    side = surface_side(cut, cut.ends[static_cast<std::size_t>(
                                 draw.below(static_cast<int>(cut.ends.size())))]);
  const auto i = static_cast<std::size_t>(side);
  const Vec2 a = cut.outline[i], b = cut.outline[i + 1];
  const bool forwards = draw.below(2) == 0;
  Flush flush;
  flush.out = normal_of(cut, side);
  flush.along = (forwards ? 1.0 : -1.0) * (b - a).normalized();
  // The ends of the domain are not goals.
  std::vector<Vec2> goals;
  if (side > 0)
    goals.push_back(a);
  if (side + 2 < cut.surface)
    goals.push_back(b);
  for (const Vec2& end : cut.ends)
    if (surface_side(cut, end) == side)
      goals.insert(goals.end(), 3, end);
  const double part = draw.between(0.3, 0.7);
  if (goals.empty())
    goals.push_back((1.0 - part) * a + part * b);
  const Vec2 goal =
      goals[static_cast<std::size_t>(draw.below(static_cast<int>(goals.size())))];
  // Side 0 of the clockwise block runs against a -> b.
  const Vec2 own = block[1] - block[0];
  const Polygon there = moved(block, angle_of(a - b) - angle_of(own), {0, 0});
  const Vec2 front = forwards ? there[0] : there[1];
  const double before = draw.between(-0.1, 0.7) * reach;
  const bool any = draw.below(10) == 0;
  const double back = any ? draw.between(0.0, 1.0) : before;
  flush.block = lifted(moved(there, 0.0, goal - back * flush.along - front), domain,
                       flush.out, 0.0);
  return flush;
}

/// The bottom of the sharpest notch, half its angle, and its axis.
struct Notch {
  Vec2 bottom = {0, 0}, axis = {0, 1};
  double half = 0.0;
};

Notch find_notch(const CutDomain& domain) {
  Notch notch;
  notch.half = 0.5 * pi;
  for (int i = 1; i + 1 < domain.surface; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vec2 left = (domain.outline[k - 1] - domain.outline[k]).normalized();
    const Vec2 right = (domain.outline[k + 1] - domain.outline[k]).normalized();
    const double half = 0.5 * std::atan2(geometry::cross(right, left), right.dot(left));
    if (half > 0.0 && half < notch.half)
      notch = {domain.outline[k], (left + right).normalized(), half};
  }
  return notch;
}

void wedge(Draws& draw, const CutDomain& cut, const Domain& domain, CutAction& action) {
  const Notch notch = find_notch(cut);
  const double other = draw.between(-0.6 * notch.half, 0.1);
  const bool matched = draw.below(3) == 0;
  const double half = std::clamp(notch.half + (matched ? 0.0 : other), 0.12, 1.3);
  const double length = draw.between(0.5, 1.0);
  const double tilt = matched || draw.below(2) == 0 ? 0.0 : draw.between(-0.1, 0.1);
  const double scale = 1.0 / std::max(length, 2.0 * length * std::tan(half));
  const double height = scale * length, width = height * std::tan(half);
  // The wedge points along its own -y.
  const Polygon block = {{0, 0}, {-width, height}, {width, height}};
  const double aside =
      draw.below(2) == 0 ? 0.0 : draw.between(-20, 20) * action.overlap;
  const Vec2 along(notch.axis.y(), -notch.axis.x());
  action.block = lifted(moved(block, angle_of(notch.axis) - 0.5 * pi + tilt,
                              notch.bottom + aside * along),
                        domain, notch.axis, draw.between(0, 10) * action.overlap);
  action.velocity = -draw() * notch.axis;
  action.load = draw.below(2) == 0 ? Vec2(0, -1) : Vec2(-notch.axis);
  action.rest_overlap = log_between(draw, 0.1, 1.0) * action.overlap;
}

void throw_at(Draws& draw, const CutDomain& cut, const Domain& domain,
              CutAction& action) {
  const Target target = draw_target(draw, cut);
  const Polygon block = draw_block(draw);
  const double gap = draw.between(0, 20) * action.overlap;
  action.block = aimed(draw, block, domain, target, action.overlap, gap);
  action.velocity = turned(-target.out, draw.between(-0.8, 0.8));
  action.load = turned(-target.out, draw.between(-0.6, 0.6));
  action.rest_overlap = log_between(draw, 0.02, 1.0) * action.overlap;
}

void press(Draws& draw, const CutDomain& cut, const Domain& domain, CutAction& action) {
  const Polygon block = draw_block(draw);
  Vec2 out;
  if (draw.below(2) == 0) {
    const Target target = draw_target(draw, cut);
    action.block = aimed(draw, block, domain, target, action.overlap, 0.0);
    out = target.out;
  } else {
    const Flush flush = lie_flush(draw, block, cut, domain, 20.0 * action.overlap);
    action.block = flush.block, out = flush.out;
  }
  action.load = turned(-out, draw.between(-0.9, 0.9));
  action.rest_overlap = action.overlap;
}

/// The farthest that a block with the speed 1 comes in a run, in overlaps.
constexpr double reach_of_a_run = 120.0;

/// A slow block has less energy than its weight on a closed joint can take, so it hangs
/// if the joint acts.
void slide(Draws& draw, const CutDomain& cut, const Domain& domain, CutAction& action) {
  const double speed = log_between(draw, 0.02, 1.0);
  const Polygon block = draw_block(draw);
  const Flush flush =
      lie_flush(draw, block, cut, domain, reach_of_a_run * speed * action.overlap);
  action.block = flush.block;
  action.velocity = speed * flush.along;
  // The load has a part along the face that friction takes up, more or less.
  const double slope = action.friction + draw.between(-0.1, 0.3);
  action.load = (slope * flush.along - flush.out).normalized();
  action.rest_overlap = log_between(draw, 0.01, 1.0) * action.overlap;
}

void roll(Draws& draw, const CutDomain& cut, const Domain& domain, CutAction& action) {
  const double speed = log_between(draw, 0.1, 1.0);
  const Polygon block = draw_roller(draw);
  const Flush flush =
      lie_flush(draw, block, cut, domain, reach_of_a_run * speed * action.overlap);
  action.block = flush.block;
  action.velocity = speed * flush.along;
  const bool forwards = geometry::cross(flush.out, flush.along) < 0.0;
  action.spin = (forwards ? -2.0 : 2.0) * speed;
  action.load = (draw.between(0.0, 0.4) * flush.along - flush.out).normalized();
  action.friction = draw.between(0.3, 0.8);
  action.rest_overlap = log_between(draw, 0.01, 0.3) * action.overlap;
}

}  // namespace

CutAction draw_action(Draws& draw, const CutDomain& cut) {
  const Domain domain = make_domain(cut.outline);
  const bool has_notch = cut.kind == "notch" || cut.kind == "step-notch";
  CutAction action;
  action.overlap = log_between(draw, 1e-5, 1e-2);
  action.damping = draw.between(0.1, 0.25);
  action.friction = draw.below(5) < 2 ? 0.0 : draw.between(0.1, 0.6);
  const int kind = draw.below(has_notch ? 9 : 5);
  if (kind < 1) {
    action.kind = "thrown";
    throw_at(draw, cut, domain, action);
  } else if (kind < 3) {
    action.kind = "slid";
    slide(draw, cut, domain, action);
  } else if (kind < 4) {
    action.kind = "rolled";
    roll(draw, cut, domain, action);
  } else if (kind < 5) {
    action.kind = "pressed";
    press(draw, cut, domain, action);
  } else {
    action.kind = "wedged";
    wedge(draw, cut, domain, action);
  }
  return action;
}

}  // namespace blocks::study
