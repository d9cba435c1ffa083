// PRIVATE to geometry/: Bentley and Ottmann's sweep of segments, exact.
#pragma once

#include <functional>
#include <vector>

#include "geometry/cut.hpp"
#include "geometry/exact/line.hpp"
#include "geometry/step_progress.hpp"

namespace blocks::geometry::exact {

/// A segment of the sweep, and what it belongs to.
struct Piece {
  int from = 0, to = 0;  ///< numbers of its ends, from < to
  int line = 0;          ///< number of its line, which runs from `from` to `to`
  int joint = 0;         ///< id; 0 on the outline
  bool outline = false;
};

/// A point where pieces begin, end or cross. Pieces are listed from the lowest to the
/// highest one beside the point. A vertical piece comes from below and is the lowest
/// one on the left; it goes on upwards as the highest one on the right.
struct SweepVertex {
  int end;                        ///< number of the end at this point; -1: a crossing
  const std::vector<int>& left;   ///< pieces that come from the left
  const std::vector<int>& right;  ///< pieces that go on to the right
  int below;                      ///< the next piece below the point; -1: none
};

/// Calls visit for all vertices, ascending in x, then y. ends: different, ascending in
/// x, then y. pieces: ascending by their first ends; they meet in points only. The time
/// is O((n + k) log n) for n pieces with k crossings. Predicates use intervals of
/// doubles, and whole numbers where these cannot decide. Rounding is upwards during
/// visits.
void sweep_pieces(const std::vector<ExactPoint>& ends, const std::vector<Piece>& pieces,
                  const Lines& lines,
                  const std::function<void(const SweepVertex&)>& visit,
                  StepProgress& progress);

}  // namespace blocks::geometry::exact
