// Finds the corners that are close enough to an edge (UPDAT, report 3.2, rule 13).
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "dynamics/cell_grid.hpp"
#include "dynamics/contact_groups.hpp"
#include "dynamics/earlier_groups.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/profile.hpp"
#include "dynamics/workers.hpp"
#include "geometry/contact_predicates.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// A corner seen from an edge, for the question whether the edge could act on it within
/// the next 2 CTOL of travel: as far outside as `near`, or as deep as rule 9 admits and
/// that much more.
struct Reach {
  Vec2 origin, along;    ///< first corner; unit vector along the edge
  double length, depth;  ///< [L] of the edge; the most that rule 9 admits
  double near;  ///< [L] 2 CTOL, the shield's reach, the slack of rules 10 and 12

  Reach(const Blocks& blocks, int b, int edge, double travel)
      : origin(blocks.corner.col(edge)) {
    const Vec2 e = Vec2(blocks.corner.col(blocks.next[edge])) - origin;
    length = e.norm();
    along = e / length;
    if (blocks.convex[b]) {
      depth = overlap(blocks.centroid.col(b));
    } else {
      depth = 0.0;
      for (int q = blocks.first_corner[b]; q < blocks.first_corner[b + 1]; ++q)
        depth = std::max(depth, 0.5 * overlap(blocks.corner.col(q)));
    }
    near = travel + geometry::contact_slack * length;
  }
  /// Overlap with the edge's line, [L].
  double overlap(const Vec2& c) const { return geometry::cross(c - origin, along); }
  /// Grows the box until it holds all that lies straight below the edge as deep as it
  /// may act: where sides cross, that is beyond the block.
  void extend(Vec2& lower, Vec2& upper) const {
    const Vec2 below = origin + depth * Vec2(along.y(), -along.x());
    for (const Vec2& end : {below, Vec2(below + length * along)})
      lower = lower.cwiseMin(end), upper = upper.cwiseMax(end);
  }
  /// In the strip of the edge, `near` beyond its ends (rule 10).
  bool between(const Vec2& c) const {
    const double s = (c - origin).dot(along);
    return s >= -near && s <= length + near;
  }
};

/// Buffers of the search, kept between searches.
struct SearchBuffers {
  explicit SearchBuffers(int threads = 1)
      : workers(std::make_unique<Workers>(threads)) {}

  std::unique_ptr<Workers> workers;
  Profile* profile = nullptr;  ///< of the run, if it is wanted
  struct Record {
    int corner, edge;  ///< corner, first corner of the edge
    auto operator<=>(const Record&) const = default;
  };
  CellGrid grid;
  std::vector<Reach> reach;  ///< of the edges of one block
  std::vector<Record> found;
  /// Records found one after the other: of one corner, edges of one block in order.
  struct Run {
    std::uint64_t place;  ///< high block, corner: by these below one low block
    int first, last;
  };
  std::vector<Run> runs;         ///< by low block
  std::vector<int> last_of_low;  ///< (blocks) before this they end, then the records do
  std::vector<Record> acted;  ///< places of what acted in the list before, in its order
  ContactGroups groups;       ///< of the present list
  long grouped_update = -1;   ///< NUPDAT when the groups were made
  /// Steps done when blocks had moved too far for the list, which has been up to date
  /// until then. -1: it is, or is old for another reason.
  long outdated_at = -1;
  const double* corners_at = nullptr;  ///< of the columns that were moved to huge pages
  EarlierGroups earlier;               ///< while the list is brought up to date
  std::vector<Displacement> moved;     ///< (threads) in this step
  PlaneContacts next_planes;
};

/// Brings the list of potential contacts up to date and sets the travel back to zero.
/// Listed: every corner that an edge of another block could act on before the next
/// search, at least one of the two free (docs/departures.md: the list holds more than
/// the corners within 2 CTOL, so that results do not depend on CTOL). Records keep
/// their elastic forces.
void update_contacts(Model& model, SearchBuffers& buffers);

/// Makes the records in buffers.found the list: the end of update_contacts, for whoever
/// looks for them in another way (src/study). No record twice.
void adopt_list(Model& model, SearchBuffers& buffers);

}  // namespace blocks::dynamics
