// How far a convex block is in a domain, measured in doubles. Independent of contacts
// and of the contact rule.
#pragma once

#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::study {

using geometry::Polygon;
using geometry::Vec2;

/// A domain of any shape, and the convex parts that fill it.
struct Domain {
  Polygon outline;  ///< [L] clockwise, simple
  std::vector<Polygon> parts;
};

/// Returns the domain with this outline, cut into convex parts.
Domain make_domain(const Polygon& outline);

/// Returns the shortest distance t >= 0 along `direction`, a unit vector, after which a
/// convex block shares no interior point with the domain, [L]. Nothing in between is
/// checked: the block may pass through the domain.
double free_shift(const Polygon& block, const Domain& domain, const Vec2& direction);

/// Returns a lower bound of the length of the shortest shift that frees a convex block
/// from the domain, [L]. It is the largest distance of a point of one outline that is
/// inside the other one from the border of the other one. Points are the corners of
/// both and points along the sides of the block.
double min_shift(const Polygon& block, const Domain& domain);

/// Returns an upper bound of that length, [L]: the shortest of the free shifts along
/// the normals of both outlines and along the bisectors of the domain's corners.
double max_shift(const Polygon& block, const Domain& domain);

}  // namespace blocks::study
