// Finds the tracks on which the traces of a family follow each other
// (docs/joint-statistics.md#tracks).
#pragma once

#include <vector>

#include "joints/length_law.hpp"
#include "joints/network.hpp"
#include "joints/spacing_fit.hpp"

namespace blocks::joints {

/// The tracks of one family and the gaps between its traces.
struct Tracks {
  /// Whether tracks were found: they are clearly apart, several traces lie on each, and
  /// traces on one track do not overlap.
  bool found = false;
  SpacingSample spacing;
  /// Gaps along the tracks: complete, or with one end beyond the window.
  LengthSample gaps;
};

/// Searches for tracks. pieces: of one family. mean: their direction [degrees];
/// deviation: the standard deviation of their directions [degrees].
Tracks find_tracks(const std::vector<Piece>& pieces, const geometry::Polygon& window,
                   double mean, double deviation);

/// Returns the spacings of joints that run through, along the line across their mean
/// direction through the middle of the window.
SpacingSample spacings_across(const Network& network, const std::vector<char>& chosen,
                              double mean, double resolution);

/// Returns the middle of the box of the window, [L].
geometry::Vec2 middle_of(const geometry::Polygon& window);

}  // namespace blocks::joints
