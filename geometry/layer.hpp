// Cuts a quadrilateral into blocks with even, listed or random spacing (LAYER, ORIENT
// and MERGE cards; report A.2.4-A.2.6, docs/theory.md#layers). The construction is
// exact for the decimals of the deck. Each vertex is rounded once, and the rounded
// result is certified.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/decimal.hpp"
#include "geometry/merge.hpp"
#include "geometry/random.hpp"
#include "geometry/tiling.hpp"

namespace blocks::geometry {

enum class Spacing { even, listed, random };

/// A layer as the deck describes it.
struct LayerRequest {
  /// [L] bottom left, top left, top right, bottom right.
  std::array<DecimalPoint, 4> corners;
  /// [L] the corners as doubles (SharedCorners); by default the nearest doubles.
  std::optional<std::array<Vec2, 4>> rounded;
  Spacing spacing = Spacing::even;
  int count = 0;                ///< blocks before MERGE, >= 1
  std::vector<Decimal> bottom;  ///< [L] listed spacing: count widths from the left, > 0
  std::vector<Decimal> top;     ///< [L] listed spacing: count widths from the left, > 0
  Decimal angle_min;  ///< degrees, anticlockwise from the normal of the mid-line
  Decimal angle_max;  ///< degrees, >= angle_min
  std::optional<Decimal> merge_ratio;  ///< MERGE: smallest width/height kept
  StreamKey stream;                    ///< for random spacing and angles
};

/// The blocks of a layer from left to right. Each cell of the mesh is BL, TL, TR, BR.
struct Layer {
  Mesh mesh;
  TilingCertificate certificate;
  std::vector<Absorption> absorptions;  ///< blocks absorbed by MERGE, in order
  bool bottom_scaled = false;  ///< widths miss the bottom line by over 1e-9 of it
  bool top_scaled = false;     ///< likewise for the top line
  int redrawn = 0;             ///< number of angles redrawn because sides crossed
  int redrawn_sides = 0;       ///< number of sides with a redrawn angle
  int ruled = 0;               ///< sides that use the ruling, see cut_layer
};

/// Derives the stream of a layer from its four corners and its number of blocks.
/// Adding, moving or removing another layer does not change it.
std::uint64_t stream_of(const LayerRequest& request);

/// Thrown when a layer cannot be cut; `kind` tells which part of the request is at
/// fault.
class LayerError : public std::runtime_error {
 public:
  enum class Kind { shape, spacing, aspect, angle };
  LayerError(Kind which, const std::string& message, const std::string& possible)
      : std::runtime_error(message), kind(which), hint(possible) {}
  Kind kind;
  std::string hint;  ///< says what would be possible
};

/// Classifies four corners by exact predicates on the decimals.
enum class QuadShape {
  convex_clockwise,
  convex_anticlockwise,
  bow_tie,
  dart,
  degenerate
};
QuadShape classify_quad(const std::array<DecimalPoint, 4>& corners);

/// Cuts the layer. Even and listed sides join corresponding points of the bottom and
/// the top line.
///
/// Random widths along the mid-line, between the midpoints of the two ends, satisfy
/// 0.2 <= width/height <= 3.0 exactly. Their sum is exactly the length of the mid-line.
/// The height is the mean distance between the two lines, that is, the layer's area
/// over the length of its mid-line. With this definition width/height is rational, so a
/// tie written in decimals is decided as written. Distribution: independent uniform
/// widths, all scaled towards one limit in proportion so that the sum fits. Every block
/// has the same distribution and mean.
///
/// If the angle of a side would make it cross another side, the angle is drawn again,
/// up to 16 times. After that, the side is the ruling at its place: the line of the
/// pencil spanned by its two neighbours. Angles and MERGE apply to random spacing only.
///
/// The corners of the layer are the given doubles, or the nearest ones. Other vertices
/// on slanted lines are rounded towards the layer. So layers that share a line or an
/// end never overlap. The same holds for layers that share a part of a line, if
/// `rounded` has the corners of SharedCorners.
///
/// Throws LayerError if the corners are not convex and clockwise, a width is not
/// positive, or |angle| exceeds 80 degrees. It also throws if the layer is too thin for
/// doubles. If no random widths within the limits exist, it throws and the hint names
/// the possible numbers of blocks.
Layer cut_layer(const LayerRequest& request);

}  // namespace blocks::geometry
