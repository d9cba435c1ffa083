// Sums over the cells of one random network, for statistics of the typical cell.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

#include "geometry/cut.hpp"

namespace blocks::validation {

/// Indices into the sums of one network. Those of `cells` to `clipped` are over the
/// sampled cells.
namespace sum {
enum Index : int {
  networks,       ///< 1
  cells,          ///< number of sampled cells
  area,           ///< [L^2]
  area_square,    ///< [L^4]
  perimeter,      ///< [L]
  sides,          ///< number of sides
  sides_square,   ///< square of the number of sides
  triangles,      ///< cells with three sides
  quadrangles,    ///< cells with four sides
  clipped,        ///< sampled cells that touch the outline; should be 0
  edges,          ///< edges whose lower end is in the window
  edge_length,    ///< [L]
  faces,          ///< cells of the whole outline
  p21,            ///< [1/L] length of joints per area of the outline, before pruning
  identities,     ///< 1 if the identity of the network was tested
  broken,         ///< 1 if it does not hold
  first_side_bin  ///< the histograms begin here
};
/// Bin k has the sampled cells with k sides; the last one also those with more.
inline constexpr int side_bins = 16;
/// Bin k has those with an area of k to k + 1 widths, in units of the exact mean.
inline constexpr int area_bins = 40;
inline constexpr double area_bin_width = 0.1;
inline constexpr int first_area_bin = first_side_bin + side_bins;
inline constexpr int count = first_area_bin + area_bins;
}  // namespace sum
using Sums = Eigen::ArrayXd;

/// A rectangle [L]. A cell or an edge is sampled if its lowest point is inside.
struct Window {
  geometry::Vec2 low, high;

  bool contains(const geometry::Vec2& p) const {
    return (p.array() > low.array()).all() && (p.array() < high.array()).all();
  }
};

/// An identity that holds in every realisation.
enum class Identity {
  none,
  lines,   ///< faces = 1 + lines + inner crossings; the outline is convex
  voronoi  ///< inner vertices = 2 (faces - 1) - nodes on the outline
};

/// Cuts the outline and sums over its cells. mean_area: exact mean area of a cell, the
/// unit of the histogram of areas.
Sums sample(const geometry::CutRequest& request, const Window& window,
            Identity identity, double mean_area);

/// Counts the lines that cross a convex outline, and their crossings inside, in
/// doubles: two chords cross if their ends alternate along the outline.
std::size_t lines_and_crossings(const geometry::CutRequest& request);

}  // namespace blocks::validation
