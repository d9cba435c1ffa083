// Cuts a quadrilateral into blocks: even, listed or random spacing (LAYER, ORIENT and
// MERGE cards; report A.2.4-A.2.6, docs/theory.md#layers). Constructed exactly on the
// decimals of the deck, rounded once per vertex, and certified on the rounded result.
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

/// What the deck asks for.
struct LayerRequest {
  std::array<DecimalPoint, 4>
      corners;  ///< [L]: bottom left, top left, top right, bottom right
  std::optional<std::array<Vec2, 4>>
      rounded;  ///< [L] the corners' doubles (SharedCorners); not given: the nearest
  Spacing spacing = Spacing::even;
  int count = 0;                ///< blocks before MERGE, >= 1
  std::vector<Decimal> bottom;  ///< [L] listed: count widths from the left, > 0
  std::vector<Decimal> top;     ///< [L] listed: count widths from the left, > 0
  Decimal angle_min;  ///< degrees, anticlockwise from the normal of the mid-line
  Decimal angle_max;  ///< degrees, >= angle_min
  std::optional<Decimal> merge_ratio;  ///< MERGE: smallest width/height kept
  StreamKey stream;                    ///< random spacing and angles
};

/// The blocks of a layer from left to right. Each cell of the mesh is BL, TL, TR, BR.
struct Layer {
  Mesh mesh;
  TilingCertificate certificate;
  std::vector<Absorption> absorptions;  ///< MERGE's record, in order
  bool bottom_scaled = false;  ///< listed widths miss the bottom line by over 1e-9
  bool top_scaled = false;     ///< likewise for the top line
  int redrawn = 0;             ///< angles drawn again because sides crossed
  int redrawn_sides = 0;       ///< sides whose angle was drawn again at least once
  int ruled = 0;               ///< sides that fell back to the ruling
};

/// Names the stream of a layer by what it is, its four corners and its number of
/// blocks: adding, moving or removing another layer does not change it.
std::uint64_t stream_of(const LayerRequest& request);

/// Which corner of the request is at fault, if one is.
class LayerError : public std::runtime_error {
 public:
  enum class Kind { shape, spacing, aspect, angle };
  LayerError(Kind which, const std::string& message, const std::string& possible)
      : std::runtime_error(message), kind(which), hint(possible) {}
  Kind kind;
  std::string hint;  ///< what would be possible
};

/// Order of four corners by exact predicates on the decimals.
enum class QuadShape {
  convex_clockwise,
  convex_anticlockwise,
  bow_tie,
  dart,
  degenerate
};
QuadShape classify_quad(const std::array<DecimalPoint, 4>& corners);

/// Cuts the layer. Even and listed sides join equal places of the bottom and the top
/// line. Random widths along the mid-line (between the middles of the two ends) obey
/// 0.2 <= width/height <= 3.0 exactly and add up to it exactly; the height, the mean
/// distance between the two lines, is the layer's area over the length of its mid-line:
/// width/height is then rational and a tie written in decimals is decided as written.
/// Law: independent uniform widths, then all drawn towards one limit in proportion so
/// that the sum fits; every block has the same law and mean. A side whose angle would
/// cross another is drawn again up to 16 times and then takes the ruling of the pencil
/// spanned by its two neighbours. Angles and MERGE concern random spacing only.
/// Corners are the doubles given, or the nearest; other vertices on slanted lines are
/// rounded towards the layer, so that layers that share a line, a part of it, or an
/// end, never overlap. Throws LayerError: corners not convex and clockwise, widths not
/// positive, no random widths possible between the limits (the hint names the counts
/// that are), |angle| > 80 degrees, a layer too thin for doubles.
Layer cut_layer(const LayerRequest& request);

}  // namespace blocks::geometry
