// Random networks of joints: sets far from the outline, Poisson lines, Voronoi cells.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/joint_sources.hpp"

namespace blocks::validation {

/// Returns the value with six digits after the point.
geometry::Decimal decimal(double value);

/// Returns an outline, clockwise.
std::vector<geometry::DecimalPoint> polygon(const std::vector<geometry::Vec2>& corners);
std::vector<geometry::DecimalPoint> rectangle(double width, double height);

/// Returns a set whose track 0 is 300 [L] from the origin, at a random phase. Seen from
/// an outline that is nearer, the tracks are stationary, as the exact values require.
/// dip: degrees. card: joint id, and the key of the stream.
geometry::JointSet distant_set(double dip, double space, std::uint64_t seed,
                               std::uint64_t card);

/// Returns the outline with the joints of all sets.
geometry::CutRequest request(const std::vector<geometry::DecimalPoint>& outline,
                             const std::vector<geometry::JointSet>& sets);

/// Returns isotropic lines with length per area tau [1/L].
geometry::CutRequest poisson_lines(const std::vector<geometry::DecimalPoint>& outline,
                                   double tau, std::uint64_t seed);

/// Returns the Voronoi cells of random points. Their number is drawn from Poisson's law
/// with this mean, as the exact values require.
geometry::CutRequest poisson_voronoi(const std::vector<geometry::DecimalPoint>& outline,
                                     double mean_points, std::uint64_t seed);

}  // namespace blocks::validation
