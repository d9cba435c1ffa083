// Transforms a scene to another frame, including every quantity that contains a length.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/polygon.hpp"
#include "study/scene.hpp"

namespace blocks::study {
namespace {

/// Replaces each corner by points on its two sides and, if rounded, between them.
geometry::Polygon cut_corners(const geometry::Polygon& outline, int chords) {
  const std::size_t n = outline.size();
  double shortest = (outline[0] - outline[n - 1]).norm();
  for (std::size_t i = 1; i < n; ++i)
    shortest = std::min(shortest, (outline[i] - outline[i - 1]).norm());
  const double cut = 0.01 * shortest;
  geometry::Polygon result;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = outline[i];
    const Vec2 a = p + cut * (outline[(i + n - 1) % n] - p).normalized();
    const Vec2 b = p + cut * (outline[(i + 1) % n] - p).normalized();
    for (int k = 0; k <= chords; ++k) {  // arc of a parabola, tangent to both sides
      const double t = static_cast<double>(k) / chords;
      result.emplace_back((1 - t) * (1 - t) * a + 2 * t * (1 - t) * p + t * t * b);
    }
  }
  return result;
}

/// Moves every side inwards by `by`.
geometry::Polygon shrink(const geometry::Polygon& outline, double by) {
  const std::size_t n = outline.size();
  geometry::Polygon result;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = (outline[i] - outline[(i + n - 1) % n]).normalized();
    const Vec2 out = (outline[(i + 1) % n] - outline[i]).normalized();
    // Inwards is to the right of a clockwise side. The sum of both normals is scaled so
    // that each side moves by `by`.
    const Vec2 normals(in.y() + out.y(), -in.x() - out.x());
    result.emplace_back(outline[i] + by / (1.0 + in.dot(out)) * normals);
  }
  return result;
}

/// The number of points that replace one corner.
int points_per_corner(Corners corners) {
  return corners == Corners::chamfered ? 2 : corners == Corners::rounded ? 4 : 1;
}

geometry::Polygon treat(const geometry::Polygon& outline, Corners corners,
                        double area) {
  switch (corners) {
  case Corners::sharp:
    return outline;
  case Corners::chamfered:
  case Corners::rounded:
    return cut_corners(outline, points_per_corner(corners) - 1);
  case Corners::skinned:
    return shrink(outline, 1e-3 * std::sqrt(area));
  }
  return outline;
}

/// Throws UnfitBlock if the outline is not valid. `block` is its number for the
/// message, counted from 1.
void check(const geometry::Polygon& outline, int block, Corners corners) {
  const geometry::OutlineCheck found = geometry::check_outline(outline);
  if (found.fault == geometry::OutlineFault::none && !found.anticlockwise)
    return;
  throw UnfitBlock(fmt::format(
      "block {} is too small for {}: {}", block,
      corners == Corners::sharp     ? "the doubles there"
      : corners == Corners::skinned ? "a skin of 0.1 % of its size"
                                    : "corners cut by 1 % of a side",
      found.anticlockwise ? "it is turned inside out" : geometry::describe(found)));
}

}  // namespace

Model place(const Model& model, const Frame& frame, Corners corners) {
  const Blocks& from = model.blocks;
  Model result = model;
  Settings& settings = result.settings;
  settings.contact_tolerance *= frame.scale;
  settings.gravity = frame.vector(settings.gravity);
  for (auto& [number, material] : settings.materials)
    material.density /= frame.scale * frame.scale;
  for (auto& [id, law] : settings.joint_laws) {
    law.normal_stiffness /= frame.scale;
    law.shear_stiffness /= frame.scale;
  }
  for (Plane& plane : settings.planes)
    plane = {frame.point(plane.a), frame.point(plane.b)};
  for (CentroidForce& load : result.loads.forces)
    load.force = frame.vector(load.force);
  const int points = points_per_corner(corners);
  for (Pressure& load : result.loads.pressures)
    load.side = load.side * points + points - 1;
  // The new domain is the bounding rectangle of the transformed one.
  const Vec2 a = model.settings.lower, b = model.settings.upper;
  settings.lower = settings.upper = frame.point(a);
  for (const Vec2& p : {b, Vec2(a.x(), b.y()), Vec2(b.x(), a.y())}) {
    settings.lower = settings.lower.cwiseMin(frame.point(p));
    settings.upper = settings.upper.cwiseMax(frame.point(p));
  }

  std::vector<NewBlock> blocks;
  for (int k = 0; k < from.size(); ++k) {
    NewBlock block{{},
                   from.material[k],
                   from.mass[k] / (from.area[k] * frame.scale * frame.scale),
                   from.fixity[k],
                   from.layer[k]};
    for (const Vec2& p : treat(from.outline(k), corners, from.area[k]))
      block.outline.push_back(frame.point(p));
    check(block.outline, k + 1, corners);
    blocks.push_back(std::move(block));
  }
  result.blocks = {};
  result.blocks.append(blocks);
  for (int k = 0; k < from.size(); ++k)
    result.blocks.velocity.col(k) = frame.vector(from.velocity.col(k));
  result.blocks.spin = from.spin;
  return result;
}

}  // namespace blocks::study
