// Cuts a domain into blocks along joints (OUTLINE ... CUT cards, docs/joints.md). The
// arrangement of outline and joints is exact. Each vertex is rounded once, and the
// rounded cells are certified.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/cut_counts.hpp"
#include "geometry/decimal.hpp"
#include "geometry/step_progress.hpp"
#include "geometry/tiling.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// A point with exact rational coordinates, [L]. Copies are cheap.
class ExactPoint {
 public:
  /// The point with exactly these coordinates, which must be finite.
  ExactPoint(const Vec2& p);  // NOLINT(google-explicit-constructor)
  /// The point as the deck gives it.
  ExactPoint(const DecimalPoint& p);  // NOLINT(google-explicit-constructor)
  /// Exact coordinates that are not doubles, see geometry/exact/shared_point.hpp.
  ExactPoint(const Vec2& nearest, std::shared_ptr<const unsigned long[]> packed);
  /// The nearest doubles, [L].
  const Vec2& nearest() const { return nearest_; }
  /// The rational coordinates, or null if the nearest doubles are exact.
  const unsigned long* packed() const { return packed_.get(); }

 private:
  Vec2 nearest_;
  std::shared_ptr<const unsigned long[]> packed_;
};

/// The largest coordinate of a domain or of a Voronoi point, [L]. Predicates have at
/// most the sixth power of four times this value, which must be a double.
inline constexpr double largest_coordinate = 0x1p100;

/// A straight piece of a joint. Pieces may cross, overlap and leave the outline.
struct JointSegment {
  ExactPoint from;
  ExactPoint to;
  int id = 0;  ///< joint id of the faces that it makes, >= 0; 0: none
};

/// A domain and the joints that cut it.
struct CutRequest {
  std::vector<DecimalPoint> outline;  ///< [L] simple and clockwise, at least 3 corners
  /// [L] the corners as doubles (SharedCorners); by default the nearest doubles.
  std::optional<std::vector<Vec2>> rounded;
  std::vector<JointSegment> joints;
  double emin = 0.0;  ///< [L] >= 0: shorter edges are contracted; 0: none
  double amin = 0.0;  ///< [L^2] >= 0: smaller cells are merged; 0: none
  /// Joint ids whose vertices cleaning does not move, and whose edges it does not merge
  /// away.
  std::vector<int> protected_joints = {};
  /// Called before and during each step of the work; may throw to stop it.
  ProgressFunction progress;
};

/// Length of the joints with one id, [L].
struct JointLength {
  double drawn = 0.0;   ///< inside the outline, before pruning
  double pruned = 0.0;  ///< removed because it separates no cells
};

/// What each step of the cutting did.
struct CutReport : CutCounts {
  std::map<int, JointLength> lengths;  ///< of each joint id
  long pruned_edges = 0;               ///< number of removed edges
};

/// One block: a cell without the T vertices that are inside its straight sides.
struct CutBlock {
  std::vector<int> corners;  ///< indices of vertices, clockwise
  std::vector<int> joints;   ///< joint id of the side from corner i to corner i + 1
};

/// The certified cells. The result does not depend on the order of the joints, nor on
/// the direction of a joint.
struct CutResult {
  /// Cells begin with their vertex of lowest index and are in order of that index.
  Mesh mesh;
  /// Joint id of each cell's edge from vertex i to vertex i + 1. Where joints overlap,
  /// the smallest id that is not 0 counts.
  std::vector<std::vector<int>> joints;
  /// The blocks, one for each cell. Blocks share no interior point.
  std::vector<CutBlock> blocks;
  TilingCertificate certificate;  ///< always holds
  CutReport report;
};

/// Thrown when a domain cannot be cut. `kind` tells which part of the request is at
/// fault.
class CutError : public std::runtime_error {
 public:
  enum class Kind { outline, joint, generator, cleaning, certificate };
  CutError(Kind which, const std::string& message, const Vec2& where,
           const std::string& next)
      : std::runtime_error(message), kind(which), place(where), hint(next) {}
  Kind kind;
  Vec2 place;        ///< [L] where it fails
  std::string hint;  ///< says what to do next
};

/// Cuts the domain.
///
/// Edges that do not separate two cells are removed: dangling ends, islands, and loops
/// that meet the rest in one vertex. What remains is the part of the network that is
/// connected to the outline by at least two disjoint paths, so every cell is simple.
/// Vertices of degree two with two collinear edges of one joint id are removed, except
/// corners of the outline. Vertices are rounded to the nearest doubles, on slanted
/// sides of the outline towards the domain, as those of layers.
///
/// Edges shorter than emin are contracted, the shortest first. The vertex on the
/// outline remains, otherwise the one with more edges. Edges of length 0 are always
/// contracted. Cells smaller than amin, and cells that rounding has destroyed, are
/// merged into the neighbour with the longest common chain. If cells are still not
/// simple, edges shorter than 4, 64 or 1024 units in the last place of the largest
/// coordinate are contracted as well; the report has this length.
/// Vertices on protected joints do not move, and simple cells are not merged across
/// these joints. Only this repair may move such a vertex, by edges of that length.
///
/// Throws CutError if the outline is not simple and clockwise, a coordinate is not
/// finite, or the certificate does not hold; the error has the place.
CutResult cut_outline(const CutRequest& request);

}  // namespace blocks::geometry
