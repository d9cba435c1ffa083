// Removes short edges and small cells from a cut domain (emin and amin of the CUT
// card). Part of cut.cpp. The certificate, not the cleaning, proves the result.
#pragma once

#include <vector>

#include "geometry/cut.hpp"
#include "geometry/cut_graph.hpp"

namespace blocks::geometry {

namespace exact {
class Lines;
}

struct CleaningLimits {
  double emin = 0.0, amin = 0.0;  ///< [L], [L^2] as in CutRequest
  /// [L] Edges up to this length may also move protected vertices.
  double repair = 0.0;
};

/// Contracts edges and merges cells as described at cut_outline. Requires numbered
/// cells, and vertices in an order that does not depend on that of the joints. A
/// cell that is simple and clockwise remains so; another one may stay as it is. lines:
/// of the segments.
void clean(CutGraph& graph, const exact::Lines& lines, const CleaningLimits& limits,
           CutReport& report, StepProgress progress);

/// Tests whether the two edges of a vertex of degree two are collinear and may become
/// one: they have one joint id, and the vertex is not a corner of the outline.
bool is_superfluous(const CutGraph& graph, const exact::Lines& lines, int vertex);

}  // namespace blocks::geometry
