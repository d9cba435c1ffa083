// Generates the joints that cut a domain: joint sets, Voronoi cells, prolonged traces
// (JSET, VORONOI and TRACES cards, docs/joints.md). Everything is exact from the
// directions on, and random numbers are the same on every machine. A progress function
// is called during the work and may throw to stop it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/cut.hpp"
#include "geometry/decimal.hpp"
#include "geometry/random.hpp"

namespace blocks::geometry {

/// How tracks of a joint set are placed. uniform: spacing + deviation. negexp:
/// exponential spacing. poisson: isotropic lines, whose length per area is 1/spacing;
/// dip is ignored, and the start is the centre of the process.
enum class SpacingLaw { uniform, negexp, poisson };

/// A mean and the half range of the uniform distribution about it.
struct Spread {
  Decimal mean;
  Decimal deviation;  ///< >= 0
};

/// A joint set in the conventions of UDEC. Tracks are parallel lines in the mean
/// direction. Along each track, traces and gaps alternate.
struct JointSet {
  int id = 0;          ///< joint id, >= 0
  Spread dip;          ///< degrees, anticlockwise from the x axis
  Spread spacing;      ///< [L] normal to the tracks; mean > 0, >= deviation
  Spread trace;        ///< [L] length of a trace; mean 0: through-going
  Spread gap;          ///< [L] between traces of a track; >= 0
  DecimalPoint start;  ///< [L] where track 0 begins with a trace
  SpacingLaw law = SpacingLaw::uniform;
  StreamKey stream;    ///< the seed, and the key of the card
  bool whole = false;  ///< traces have their full length beyond the outline too
};

/// The largest number of tracks, traces or points that a generator makes.
inline constexpr double max_joint_pieces = 1e7;

/// Returns the expected number of pieces in the bounding box of the outline, counting
/// the tracks and traces between the start and the box. Cheap; call it before
/// joint_set.
double expected_pieces(const JointSet& set, const std::vector<DecimalPoint>& outline);

/// Generates the pieces of the set that may meet the outline. Pieces reach beyond its
/// bounding box where they leave it.
///
/// Track k is at the sum of k spacings from the start, on the left of the direction for
/// k > 0. Track 0 has a trace that begins at the start; the phase of the others is
/// uniform, such that the set is stationary along the tracks. The direction of a trace
/// deviates from its track about the middle of the trace; a through-going line, about
/// the foot of the start. Deviations with half range 0 are exact decimals.
///
/// Throws CutError (generator) for a value out of range or more than max_joint_pieces.
std::vector<JointSegment> joint_set(const JointSet& set,
                                    const std::vector<DecimalPoint>& outline,
                                    const ProgressFunction& progress = {});

/// Voronoi cells of random or given points.
struct VoronoiRequest {
  int id = 0;     ///< joint id, >= 0
  int count = 0;  ///< number of random points, >= 1; ignored if points are given
  std::vector<Vec2>
      points;     ///< [L] points instead of random ones; duplicates count once
  int lloyd = 0;  ///< rounds of Lloyd's relaxation, >= 0
  StreamKey stream;
};

/// The edges of the cells, and the points after relaxation.
struct VoronoiCells {
  std::vector<JointSegment> edges;
  std::vector<Vec2> points;
};

/// Generates the edges of the Voronoi cells. Random points are uniform in the outline.
/// Vertices of the cells are rounded once, to the nearest doubles. Edges to infinity
/// end outside the bounding box. A point whose relaxed place is outside the outline is
/// not moved. Throws CutError (generator).
VoronoiCells voronoi_cells(const VoronoiRequest& request,
                           const std::vector<DecimalPoint>& outline,
                           const ProgressFunction& progress = {});

/// Estimates the number of crossings of segments inside a box, [L]: those of some
/// segments with all others are counted. Exact for up to 3,000 segments. The same
/// segments give the same number.
double likely_crossings(const std::vector<JointSegment>& segments, const Vec2& low,
                        const Vec2& high, const ProgressFunction& progress = {});

/// Returns the traces, each ended on both sides of its middle where it first meets one
/// of the joints, exactly. A joint through the middle ends it towards its first end;
/// joints along a trace do not end it. Joints need not be inside the outline.
std::vector<JointSegment> ended_at(const std::vector<JointSegment>& traces,
                                   const std::vector<JointSegment>& joints,
                                   const ProgressFunction& progress = {});

/// What prolonged did.
struct Prolongation {
  std::vector<JointSegment> traces;  ///< in the given order
  std::size_t ends = 0;              ///< number of ends that were prolonged
  std::size_t loose = 0;             ///< number of ends that dangled, prolonged or not
  double largest = 0.0;              ///< [L] largest prolongation
  Vec2 place = Vec2::Zero();         ///< [L] the end with the largest one, as given
};

/// Prolongs dangling ends of traces to the first other joint or side of the outline, if
/// it is at most `snap` [L] away along the trace. An end dangles if it is inside the
/// outline and on no other joint. Two ends that dangle still are prolonged to the point
/// where their prolongations meet, if it is as near to both and the first such point
/// for both. All ends are tested against the joints as given, so the order of the
/// traces has no effect. others: joints that are not prolonged.
Prolongation prolonged(const std::vector<JointSegment>& traces, const Decimal& snap,
                       const std::vector<JointSegment>& others,
                       const std::vector<DecimalPoint>& outline,
                       const ProgressFunction& progress = {});

}  // namespace blocks::geometry
