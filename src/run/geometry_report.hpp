// `blocks check --geometry`: how good the blocks are as bodies of a run. What is
// gathered, and how it reads as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "model/assembly_certificate.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// One measure over all blocks, with its extremes.
struct Measure {
  struct Place {
    double value = 0.0;
    int block = 0;           ///< from 0
    int corner = 0;          ///< of the block, from 0
    Vec2 at = Vec2::Zero();  ///< [L]
  };
  double smallest = 0.0, median = 0.0, largest = 0.0;
  std::vector<Place> worst;  ///< at most 10 beyond the median, the worst first

  /// Blocks between edges[i] and edges[i + 1], the last class closed.
  std::vector<double> edges;
  std::vector<long> counts;
};

/// Above this the distance between neighbouring doubles is too coarse for the blocks:
/// a contact overlaps by about 1e-6 of an edge, and this leaves it four digits.
constexpr double coarsest_resolution = 1e-10;

struct GeometryReport {
  std::string file;
  int blocks = 0, corners = 0;
  Measure area;    ///< [L^2]; worst: smallest
  Measure aspect;  ///< worst: largest
  Measure edge;    ///< [L] shortest of each block
  Measure angle;   ///< degrees, smallest of each block
  AssemblyCertificate certificate;
  std::vector<LayerRecord> layers;
  std::vector<MergeRecord> merges;

  /// ulp over the shortest edge of all.
  double resolution() const {
    return blocks > 0 ? certificate.ulp / edge.smallest : 0.0;
  }
  bool resolved() const { return resolution() <= coarsest_resolution; }
};

/// Looks at the blocks as they stand, of which the first `moved` have moved. n log n.
GeometryReport examine_geometry(const std::string& file, const Model& model,
                                int moved = 0);

/// For a terminal of 80 columns.
std::string text(const GeometryReport& report);

/// The same figures as one JSON object; blocks and corners count from 1.
std::string json(const GeometryReport& report);

}  // namespace blocks::run
