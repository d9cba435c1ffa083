// Finds the corners that are close enough to an edge (UPDAT, report 3.2, rule 13).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "dynamics/block_reach.hpp"
#include "dynamics/cell_grid.hpp"
#include "dynamics/contact_groups.hpp"
#include "dynamics/earlier_groups.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/near_pairs.hpp"
#include "dynamics/pair_contacts.hpp"
#include "dynamics/profile.hpp"
#include "dynamics/workers.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Buffers of the search, kept between searches.
struct SearchBuffers {
  explicit SearchBuffers(int threads = 1)
      : workers(std::make_unique<Workers>(threads)) {}

  std::unique_ptr<Workers> workers;
  Profile* profile = nullptr;  ///< of the run, if it is wanted
  CellGrid grid;
  BlockReach reach;  ///< of one block
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
  // contacts decided pair by pair
  PairContacts pairs;
  NearSearch near;
  std::vector<NearPair> near_pairs;
};

/// [L] Half of the reach of the list: CTOL, or as far as the fastest block goes in some
/// steps, but for a part of the size of blocks. A larger list costs each step more.
double list_tolerance(const Model& model);

/// Corners that may touch a plane before one has gone so far, [L]. Contacts keep their
/// springs.
void update_plane_contacts(Model& model, SearchBuffers& buffers, double tolerance);

/// Brings the list of potential contacts up to date. Listed: every corner that an edge
/// of another block could act on before the next search, at least one of the two free
/// (docs/departures.md: the list holds more than the corners within 2 CTOL, so that
/// results do not depend on CTOL), and whatever acted. Records keep their elastic
/// forces.
void update_contacts(Model& model, SearchBuffers& buffers);

/// Makes the records in buffers.found the list until corners have gone so far, [L]: the
/// end of update_contacts, for whoever looks for them in another way (src/study). No
/// record twice.
void adopt_list(Model& model, SearchBuffers& buffers, double tolerance);

}  // namespace blocks::dynamics
