// The certificate of a cut domain (docs/joints.md): the tiling of the cells, the
// outline of the request, and the areas. Part of cut.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/cut.hpp"

namespace blocks::geometry {

/// Why and where a certificate does not hold.
struct CutFault {
  std::string fault;
  Vec2 place;  ///< [L]
};

/// Returns the corners of the requested outline as doubles.
std::vector<Vec2> rounded_corners(const CutRequest& request);

/// Tests whether the outline of the mesh has all corners of the request in their order,
/// beginning with corner 0, and its other points on the sides between them in their
/// order. A point has the coordinate of an axis-parallel side. On other sides it is
/// never outside, and at most 64 units in the last place of the largest coordinate
/// inside; to this is added how far the request moves the ends of the side from the
/// nearest doubles. Returns the first deviation.
std::optional<CutFault> outline_deviation(const Mesh& mesh, const CutRequest& request);

/// Returns the first fault of the result, or nothing if the certificate holds. The
/// fault names the joints that meet at its place. Requires the certificate of the
/// tiling.
std::optional<CutFault> find_fault(const CutResult& result, const CutRequest& request,
                                   StepProgress& progress);

}  // namespace blocks::geometry
