// Joint sets, as JSET cards make them, fitted to the traces of a map
// (docs/joint-statistics.md#from-a-map-to-joint-sets).
#pragma once

#include <string>
#include <vector>

#include "geometry/joint_sources.hpp"
#include "joints/estimate.hpp"
#include "joints/families.hpp"
#include "joints/network.hpp"

namespace blocks::joints {

/// The fields of a JSET card with their intervals.
struct SetFit {
  int id = 1;              ///< joint id
  std::size_t pieces = 0;  ///< parts of traces from which it was fitted
  Family family;
  double p21 = 0.0;  ///< [1/L] of the family in the map
  geometry::SpacingLaw law = geometry::SpacingLaw::negexp;
  Estimate dip, ddev;                             ///< [degrees]
  Estimate space, sdev;                           ///< [L]
  Estimate trace, tdev;                           ///< [L]; trace 0: joints run through
  Estimate gap, gdev;                             ///< [L]
  geometry::Vec2 start = geometry::Vec2::Zero();  ///< [L] x0, y0
  int until = 0;  ///< id of the set at which the traces end; 0: in the rock
  std::vector<std::string> notes;  ///< what the map does not tell, one per line
};

struct NetworkFit {
  std::vector<SetFit> sets;
  int components = 0;  ///< of the mixture, before some were joined
};

/// Fits one set for each family of directions, at most `max` of them. At least
/// three scattered traces make one more set: with the law POISSON if they run through,
/// otherwise with ddev 90. shortest: [L] shorter
/// traces were not mapped everywhere. The network has pieces. There are no sets if
/// fewer than three traces are scattered and no others have a family.
NetworkFit fit_sets(const Network& network, double shortest = 0.0,
                    int max = max_families);

}  // namespace blocks::joints
