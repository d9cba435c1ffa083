// Working memory of a run's steps, and how far ahead a search looks for contacts.
#pragma once

#include <memory>
#include <vector>

#include "dynamics/motion.hpp"
#include "dynamics/near_pairs.hpp"
#include "dynamics/pair_contacts.hpp"
#include "dynamics/profile.hpp"
#include "dynamics/workers.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// What the steps of a run keep besides the model. It influences the run time only,
/// never the results.
struct SearchBuffers {
  explicit SearchBuffers(int threads = 1)
      : workers(std::make_unique<Workers>(threads)) {}

  std::unique_ptr<Workers> workers;
  Profile* profile = nullptr;  ///< where the time of the run is counted, if at all
  PairContacts pairs;          ///< near pairs of blocks and their contacts
  long grouped_update = -1;    ///< SearchState::updates when the pairs were found
  /// Model::steps when the pairs became outdated because blocks had moved; -1: they are
  /// up to date, or outdated for another reason.
  long outdated_at = -1;
  const double* corners_at = nullptr;  ///< corner column that is in huge pages
  std::vector<Displacement> moved;     ///< (threads) motion of this step
  PlaneContacts next_planes;           ///< memory of update_plane_contacts
  NearSearch near;                     ///< memory of find_near_pairs
  std::vector<NearPair> near_pairs;
};

/// [L] How far corners may move before near pairs have to be found again: CTOL, or as
/// far as the fastest block moves in 250 steps, but at most a tenth of the block size.
/// A longer distance makes searches rarer and each step more expensive.
double list_tolerance(const Model& model);

}  // namespace blocks::dynamics
