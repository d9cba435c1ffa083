// `blocks check --geometry`: measures the quality of the blocks and reports it as text
// and as JSON.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/assembly_certificate.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// The distribution of one measure over all blocks, with its extremes.
struct Measure {
  struct Place {
    double value = 0.0;
    int block = 0;           ///< counted from 0
    int corner = 0;          ///< of the block, counted from 0
    Vec2 at = Vec2::Zero();  ///< [L]
  };
  double smallest = 0.0, median = 0.0, largest = 0.0;
  std::vector<Place> worst;  ///< at most 10 that are worse than the median, worst first

  /// counts[i] is the number of blocks in [edges[i], edges[i + 1]); the last class
  /// includes its upper edge.
  std::vector<double> edges;
  std::vector<long> counts;
};

/// The coarsest acceptable spacing of doubles, relative to the shortest edge. A contact
/// overlaps by about 1e-6 of an edge, so four digits of its overlap remain at this
/// limit.
constexpr double coarsest_resolution = 1e-10;

struct GeometryReport {
  std::string file;
  int blocks = 0, corners = 0;
  Measure area;    ///< [L^2]; the smallest is the worst
  Measure aspect;  ///< the largest is the worst
  Measure edge;    ///< [L] shortest edge of each block
  Measure angle;   ///< in degrees, smallest angle of each block
  AssemblyCertificate certificate;
  std::vector<LayerRecord> layers;
  std::vector<MergeRecord> merges;
  std::vector<CutRecord> cuts;
  std::vector<JointLengthRecord> joint_lengths;
  /// Number of blocks with each number of sides; empty if no CUT card made blocks.
  std::map<int, long> sides;

  /// The ulp of the coordinates over the shortest edge of all blocks.
  double resolution() const {
    return blocks > 0 ? certificate.ulp / edge.smallest : 0.0;
  }
  bool resolved() const { return resolution() <= coarsest_resolution; }
};

/// Examines the blocks at their present positions. The first `moved` of them have
/// moved. The cost is O(n log n).
GeometryReport examine_geometry(const std::string& file, const Model& model,
                                int moved = 0);

/// The report for a terminal of 80 columns.
std::string text(const GeometryReport& report);

/// The same numbers as one JSON object; blocks and corners are counted from 1.
std::string json(const GeometryReport& report);

}  // namespace blocks::run
