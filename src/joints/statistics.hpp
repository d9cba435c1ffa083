// All statistics of one map of traces (docs/joint-statistics.md).
#pragma once

#include <string>
#include <vector>

#include "joints/families.hpp"
#include "joints/mean_length.hpp"
#include "joints/network.hpp"
#include "joints/scanlines.hpp"

namespace blocks::joints {

struct StatisticsOptions {
  double shortest = 0.0;  ///< [L] >= 0: shorter traces were not mapped everywhere
  std::vector<Scanline> scanlines;  ///< given by the user
  int max_families = joints::max_families;
};

/// The topology of a network (Sanderson and Nixon 2015). NaN where a count is 0.
struct Topology {
  double branches = 0.0;         ///< half of the branches that meet at I, Y and X nodes
  double lines = 0.0;            ///< (I + Y) / 2 traces
  double mean_branch = unknown;  ///< [L] length of all over the branches
  double connections_per_branch = unknown;  ///< (3 Y + 4 X) / branches, 0 to 2
  double connections_per_line = unknown;    ///< 2 (Y + X) / lines
  double branch_density = 0.0;              ///< [1/L^2] B20
  double branch_intensity = unknown;        ///< [-] B22 = B21^2 / B20
  /// Numbers of branches by their ends.
  std::size_t cc = 0, ci = 0, ii = 0, at_window = 0;
};

/// A family of directions and its traces.
struct FamilyStatistics {
  bool scattered = false;  ///< traces without a preferred direction, and no family
  Family family;
  std::size_t pieces = 0;
  double deviation = unknown;  ///< [degrees] standard deviation of the directions
  double share = 0.0;          ///< of all length, 0 to 1
  TraceDensity density;
  SpacingStatistics spacing;  ///< along lines normal to the mean direction; if
                              ///< scattered, along x
};

struct MapStatistics {
  std::string name;
  double shortest = 0.0;  ///< [L]
  Network network;
  Topology topology;
  TraceDensity density;
  FittedLaw exponential, lognormal;
  Mixture mixture;
  std::vector<FamilyStatistics> families;    ///< by ascending direction
  SpacingStatistics along_x, along_y;        ///< of all traces, along 0 and 90 degrees
  std::vector<SpacingStatistics> scanlines;  ///< as in the options
};

Topology topology_of(const Network& network);

/// Computes everything. Throws std::runtime_error if the window shows no trace, and
/// geometry::CutError for a faulty window.
MapStatistics statistics_of(const TraceMap& map, const StatisticsOptions& options);

/// Returns the statistics of several maps as columns of a table.
std::string statistics_text(const std::vector<MapStatistics>& maps);

/// Returns {"maps": [...]} with all numbers; those that are not known are null.
std::string statistics_json(const std::vector<MapStatistics>& maps);

}  // namespace blocks::joints
