// Measures of the blocks that a deck generates: what a sweep records of each run before
// its first step. Independent of plans and folders.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "model/assembly_certificate.hpp"
#include "model/model.hpp"

namespace blocks::sweep {

/// The distribution of a value over the blocks of one run; NaN if there is none.
struct Spread {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double min = none, mean = none, max = none;
  double sd = none;  ///< with divisor n - 1; NaN for one value
  /// Percentiles of order statistics: p % is at the index p / 100 (n - 1) of the n
  /// values in ascending order, with linear interpolation.
  double p5 = none, p50 = none, p95 = none;
};

/// Returns the distribution of the values.
Spread spread_of(std::vector<double> values);

/// The measures of docs/distributions.md#measures-of-generated-blocks. Measured are the
/// blocks that LAYER cards made, or all blocks if no LAYER card made any; removed ones
/// are left out.
struct LayerMeasures {
  int layers = 0;          ///< LAYER cards that acted
  int blocks = 0;          ///< measured blocks, after MERGE
  int absorbed = 0;        ///< blocks that MERGE absorbed
  int angles_redrawn = 0;  ///< number of times that an angle was drawn again
  int sides_redrawn = 0;   ///< sides with an angle that was drawn again
  int sides_ruled = 0;     ///< sides that take the ruling, because no angle fits
  Spread area;             ///< [L^2]
  Spread aspect;           ///< >= 1, as in `blocks check --geometry`
  Spread shortest_side;    ///< [L] of each block
  Spread smallest_angle;   ///< degrees, of each block
  /// [L] along the mid-line of the layer, of the blocks of all layers. It is not
  /// measured in layers that have moved.
  Spread width;
  double p21 = Spread::none;           ///< [1/L] length of joints over area of blocks
  int t_vertices = 0, x_vertices = 0;  ///< geometry::JointNetwork
  bool certificate = true;             ///< no two of all blocks of the deck overlap
  int overlaps = 0, gaps = 0;          ///< of all blocks of the deck
};

/// Returns the widths of the blocks of one layer along its mid-line, [L], from the
/// left. The mid-line joins the middles of the two ends of the layer. The widths add up
/// to its length, up to rounding; those of removed blocks are left out. The blocks must
/// not have moved.
std::vector<double> widths_of_layer(const Blocks& blocks, const LayerRecord& layer);

/// Measures the blocks of a model at its first motion. certificate: of this model; null
/// if it has no blocks.
LayerMeasures measure_layers(const Model& model, const SharedCertificate& certificate);

/// Returns {"layers": 1, "blocks": 100, ..., "aspect": {"min": 1.0, ...}, ...}. Values
/// that do not exist are null.
nlohmann::ordered_json to_json(const LayerMeasures& measures);

}  // namespace blocks::sweep
