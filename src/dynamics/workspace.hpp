// Working memory for the steps of a run.
#pragma once

#include <memory>
#include <vector>

#include "dynamics/contact_forces.hpp"
#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/decide_contacts.hpp"
#include "dynamics/decisions/contact_rule.hpp"
#include "dynamics/decisions/decisions.hpp"
#include "dynamics/energy/energy.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/rules/block_parts.hpp"
#include "dynamics/search/near_pairs.hpp"
#include "dynamics/search/pair_index.hpp"
#include "dynamics/spring_owner.hpp"
#include "dynamics/support/profile.hpp"
#include "dynamics/support/work_split.hpp"
#include "dynamics/support/workers.hpp"
#include "model/contacts.hpp"

namespace blocks::dynamics {

/// State that the steps of a run keep in addition to the model. It may be discarded
/// after catch_up(). Results then have the same bits if its decisions are copied
/// (kept_decisions()). Without the copy, the next step decides all pairs again, and
/// results may differ by the tolerances within which decisions are kept.
struct Workspace {
  explicit Workspace(int threads = 1)
      : workers(std::make_unique<Workers>(threads)),
        moved(static_cast<std::size_t>(threads)) {
    deciding.resize(static_cast<std::size_t>(threads));
    forces.threads.resize(static_cast<std::size_t>(threads));
  }

  /// The contact rule. `blocks study` puts its variants here.
  const ContactRule* rule = &exact_rule();
  std::unique_ptr<Workers> workers;
  Profile* profile = nullptr;  ///< accumulates the time of each phase; may be null
  WorkSplit split;

  SpringOwner springs;
  PairIndex index;
  BlockParts parts;
  Decisions decisions;
  ContactArrays contacts;

  /// (n) Whether a block is a piece of a block that has split since the arrays were
  /// made; empty: none is.
  std::vector<char> changed_blocks;

  // Working memory of single calls.
  NearSearch search;
  PairIndex last_index;  ///< that of the search before
  std::vector<NearPair> near_pairs;
  std::vector<PlaneContact> plane_contacts;
  /// The column of corners for which the columns of blocks were last moved to huge
  /// pages.
  const double* corners_in_huge_pages = nullptr;
  std::vector<DecisionThread> deciding;
  ForceMemory forces;
  EnergyMemory energy;
  std::vector<Displacement> moved;  ///< (threads)
};

}  // namespace blocks::dynamics
