// One time step whose contacts are decided pair by pair.
#pragma once

#include <utility>
#include <vector>

#include "dynamics/contact_search.hpp"
#include "dynamics/pair_forces.hpp"
#include "dynamics/step.hpp"

namespace blocks::dynamics {

/// Brings the pairs of blocks up to date that may touch before a corner has gone as far
/// as search.left, and adds the pairs `also`, which are ordered. Contacts keep their
/// springs.
void update_pairs(Model& model, SearchBuffers& buffers,
                  const std::vector<NearPair>& also = {});

/// Contact forces, motion and the rest of a step. With `readings`, or where a contact
/// is pressed by more than `alarm`, [F], the list of the model becomes what acted in
/// it, with forces and overlaps; else it stays behind until catch_up_pairs().
template <class Rules>
Displacement advance_by_pairs(Model& model, SearchBuffers& buffers, bool readings,
                              double alarm, const Rules& rules = Rules()) {
  PairContacts& all = buffers.pairs;
  Blocks& blocks = model.blocks;
  const double dt = model.time_step.dt;
  update_pairs(model, buffers);
  {
    const Profile::Timer timer(buffers.profile, Profile::decisions);
    decide_contacts(rules, blocks, all, model.settings, dt, *buffers.workers);
    if (buffers.profile != nullptr)
      for (PairContacts::Share& share : all.shares)
        buffers.profile->exact_calls += std::exchange(share.exact_calls, 0);
  }
  Extremes touching;
  {
    const Profile::Timer timer(buffers.profile, Profile::forces);
    touching = evaluate_pairs(blocks, all, model.settings, dt, *buffers.workers,
                              Rules::transfers_springs);
    all.read = readings || !(touching.spring <= alarm);
    if (all.read)
      read_pairs(blocks, model.contacts, all, model.settings, dt);
  }
  all.list_is_behind = true;
  return move(model, buffers, all, touching);
}

/// Brings the list of the model up to date.
void catch_up_pairs(Model& model, SearchBuffers& buffers);

template <class Rules>
Displacement step_by_pairs(Model& model, SearchBuffers& buffers,
                           const Rules& rules = Rules()) {
  const Displacement moved = advance_by_pairs(model, buffers, true, 0.0, rules);
  catch_up_pairs(model, buffers);
  return moved;
}

}  // namespace blocks::dynamics
