// Scenes in which blocks strike a floor or each other.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "geometry/contact_predicates.hpp"
#include "study/scene_builder.hpp"
#include "study/scenes.hpp"

namespace blocks::study::scenes {

Scene needle() {
  constexpr double speed = 3.0, width = 0.02;
  const double c = std::cos(std::numbers::pi / 18.0),
               s = std::sin(std::numbers::pi / 18.0);
  SceneBuilder draft("needle",
                     "a needle strikes a wide floor at 10 degrees and glides on", 600);
  draft.box(-10, -1, 20, 1, true);
  // point at distance t along and w across the needle, from its foot
  const auto at = [&](double t, double w) {
    return Vec2(2.0 + t * s - w * c, 0.005 + t * c + w * s);
  };
  const int b = draft.add({at(0, 0), at(0, width), at(1, width), at(1, 0)}, false);
  draft.velocity(b, -speed, -speed);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(-speed * static_cast<double>(k) * dt, 0);
  });
}

Scene plate() {
  SceneBuilder draft(
      "plate", "a thin plate strikes a floor so fast that it sinks in by its thickness",
      600);
  draft.stiffness(1e6);
  draft.box(-10, -1, 20, 1, true);
  const int b = draft.box(0, 0.01, 1, 0.02);
  draft.velocity(b, 3.0, -6.0);
  return draft.moves(
      b, [](long k, double dt) { return Vec2(3.0 * static_cast<double>(k) * dt, 0); });
}

Scene tip() {
  constexpr double speed = 3.0;
  SceneBuilder draft("tip", "a tip strikes a floor of boxes and glides over a joint",
                     600);
  draft.stiffness(1e9);
  for (int i = 0; i < 4; ++i)
    draft.box(0.5 * i - 1, -1, 0.5, 1, true);
  // The centroid is above the tip, so that the block does not turn. The tip is at the
  // joint when it is deepest.
  const double side = 0.4 * std::tan(std::numbers::pi / 6.0), start = -0.0045;
  const int b =
      draft.add({{start, 0.001}, {start - side, 0.401}, {start + side, 0.401}}, false);
  draft.velocity(b, speed, -speed);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(speed * static_cast<double>(k) * dt, 0);
  });
}

namespace {

/// A tip that falls on the joint of two flush fixed boxes.
struct Impact {
  double angle = 0.0;     ///< of the tip, in degrees
  double height = 0.0;    ///< of the triangle, [L]
  double width = 0.0;     ///< of a box, [L]
  double aside = 0.0;     ///< distance of the tip from the joint, [L]
  double speed = 0.0;     ///< downwards, [L/T]
  double sideways = 0.0;  ///< [L/T]
};

/// A closed joint of fixed flush boxes hides its sides, so the tip must come back as
/// from a floor of one piece. It keeps its speed, because the spring is undamped. It
/// comes back straight, because the floor is frictionless and the centroid is above the
/// tip.
///
/// Let T be the root of mass over stiffness: the tip falls for T, touches the floor for
/// pi T and rises. The deepest overlap is the speed times T. Two springs at the joint
/// instead of one throw the tip back earlier by 0.9 T. So it may miss its expected
/// position by a tenth of its path.
Scene bounces(SceneBuilder draft, double stiffness, const Impact& impact) {
  draft.stiffness(stiffness);
  const double w = impact.width,
               half = impact.height * std::tan(0.5 * radians(impact.angle));
  draft.box(-w, -4 * w, w, 4 * w, true);
  draft.box(0, -4 * w, w, 4 * w, true);
  const double time = std::sqrt(2000.0 * half * impact.height / stiffness);  // T
  const double gap = impact.speed * time, top = gap + impact.height;
  const double tip =
      impact.aside - impact.sideways * (1.0 + 0.5 * std::numbers::pi) * time;
  const int b = draft.add({{tip, gap}, {tip - half, top}, {tip + half, top}}, false);
  draft.velocity(b, impact.sideways, -impact.speed);
  Scene scene = draft.moves(b, [impact, gap, time](long k, double dt) {
    const double t = static_cast<double>(k) * dt;
    return Vec2(impact.sideways * t,
                impact.speed * (t - std::numbers::pi * time) - 2.0 * gap);
  });
  scene.known_motion = false;  // known at the end only
  scene.max_astray = 2.0 * gap;
  return scene;
}

}  // namespace

/// In half of the frames the tip falls on the joint itself, otherwise beside it.
Scene stake(Draws& draw) {
  SceneBuilder draft("stake",
                     "a stake of 4 to 40 degrees is driven into a closed joint", 600);
  Impact impact{draw.between(4, 40), 0.4, 1, 0, 3, 0};
  const double aside = draw.between(-1e-3, 1e-3);
  impact.aside = draw.below(2) == 0 ? 0.0 : aside;
  return bounces(draft, 1e9, impact);
}

/// The tip falls within twice the slack of the joint, a few millionths of a box's
/// width. Its overlaps are a fifth of a micrometre, less than the slack.
Scene toe(Draws& draw) {
  SceneBuilder draft(
      "toe", "a pointed block strikes flush boxes within the slack of their joint",
      600);
  Impact impact{draw.between(20, 100), 0.2, 0.25, 0, 3e-3, 0};
  impact.aside = draw.between(-2, 2) * geometry::contact_slack * impact.width;
  impact.sideways = draw.below(2) == 0 ? 0.0 : draw.between(-3e-3, 3e-3);
  Scene scene = bounces(draft, 1e10, impact);
  scene.farthest = 1e3;
  return scene;
}

namespace {

geometry::Polygon shifted(geometry::Polygon outline, const Vec2& by) {
  for (Vec2& p : outline)
    p += by;
  return outline;
}

/// A triangle around the origin with corners on a circle and with no angle below 4
/// degrees.
geometry::Polygon random_triangle(Draws& draw, double radius) {
  constexpr double min = 8.0;  // an arc is twice its inscribed angle
  while (true) {
    std::array<double, 3> at = {draw.between(0, 360), draw.between(0, 360),
                                draw.between(0, 360)};
    std::sort(at.begin(), at.end(), std::greater<>());  // clockwise
    if (at[0] - at[1] < min || at[1] - at[2] < min || at[2] + 360 - at[0] < min)
      continue;
    geometry::Polygon outline;
    for (const double angle : at)
      outline.emplace_back(radius * std::cos(radians(angle)),
                           radius * std::sin(radians(angle)));
    return shifted(outline, -(outline[0] + outline[1] + outline[2]) / 3.0);
  }
}

/// The farthest point of an outline at the height y, as sign times x: to the right
/// (sign = 1) or to the left (-1). It is minus infinity above and below the outline.
double reach(const geometry::Polygon& outline, double y, double sign) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if ((a.y() <= y && y <= b.y()) || (b.y() <= y && y <= a.y())) {
      const double share = a.y() == b.y() ? 0.0 : (y - a.y()) / (b.y() - a.y());
      farthest = std::max(farthest, sign * (a.x() + share * (b.x() - a.x())));
    }
  }
  return farthest;
}

/// The distance that the other outline must be moved to the right so that it only
/// touches the first one.
double clearance(const geometry::Polygon& one, const geometry::Polygon& other) {
  double needed = -std::numeric_limits<double>::infinity();
  for (const geometry::Polygon* outline : {&one, &other})
    for (const Vec2& p : *outline)
      needed = std::max(needed, reach(one, p.y(), 1.0) + reach(other, p.y(), -1.0));
  return needed;
}

/// The height of the lowest corner (sign = -1) or the highest one (1), as sign times y.
double extent(const geometry::Polygon& outline, double sign) {
  double max = sign * outline[0].y();
  for (const Vec2& p : outline)
    max = std::max(max, sign * p.y());
  return max;
}

}  // namespace

namespace {

/// Two triangles fly at each other. In half of the frames only their tips meet: their
/// extents across the flight overlap by up to 10 cm.
void throw_two(SceneBuilder& draft, Draws& draw, double speed) {
  const geometry::Polygon one = random_triangle(draw, 0.5);
  const geometry::Polygon other = random_triangle(draw, 0.5);
  const double highest = extent(one, 1.0) + extent(other, -1.0);
  const double lowest = -extent(one, -1.0) - extent(other, 1.0);
  const double share = draw();
  const double aside = draw.below(2) == 0 ? highest - 0.1 * std::pow(share, 3)
                                          : lowest + share * (highest - lowest);
  const double away = clearance(one, shifted(other, {0, aside})) + 0.005;
  draft.velocity(draft.add(one, false), speed, 0);
  draft.velocity(draft.add(shifted(other, {away, aside}), false), -speed, 0);
}

/// Six triangles on a circle fly at its centre and press each other there.
void throw_six(SceneBuilder& draft, Draws& draw, double speed) {
  for (int i = 0; i < 6; ++i) {
    const Vec2 out(std::cos(radians(60 * i)), std::sin(radians(60 * i)));
    const int b = draft.add(shifted(random_triangle(draw, 0.35), 0.75 * out), false);
    draft.velocity(b, -speed * out.x(), -speed * out.y());
  }
}

}  // namespace

/// The paths of the triangles are unknown, but none may pass through another. No
/// overlap may be deeper than that of a spring that takes up all the energy.
Scene triangles(Draws& draw) {
  constexpr double speed = 4.0, stiffness = 1e8;
  SceneBuilder draft("triangles", "random triangles are thrown at each other", 1500);
  draft.stiffness(stiffness);
  const bool two = draw.below(2) == 0;
  two ? throw_two(draft, draw, speed) : throw_six(draft, draw, speed);
  Scene scene = draft.rests(1.0);
  scene.known_motion = false;
  scene.looks = 50;
  scene.max_shared = 1.0;
  scene.max_depth = std::sqrt(2.0 * totals(draft.model()).kinetic_energy / stiffness);
  return scene;
}

}  // namespace blocks::study::scenes
