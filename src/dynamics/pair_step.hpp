// One time step whose contacts are decided pair by pair.
#pragma once

#include "dynamics/contact_search.hpp"
#include "dynamics/pair_forces.hpp"
#include "dynamics/step.hpp"

namespace blocks::dynamics {

/// Brings the pairs of blocks up to date that may touch before a corner has gone as far
/// as search.left. Contacts keep their springs.
void update_pairs(Model& model, SearchBuffers& buffers);

/// Contact forces, motion and the rest of a step. With `readings`, or where a contact
/// is pressed by more than `alarm`, [F], the list of the model becomes what acted in
/// it, with forces and overlaps; else it stays behind until catch_up_pairs().
template <class Rules>
Displacement advance_by_pairs(Model& model, SearchBuffers& buffers, bool readings,
                              double alarm) {
  PairContacts& all = buffers.pairs;
  Blocks& blocks = model.blocks;
  const double dt = model.time_step.dt;
  update_pairs(model, buffers);
  {
    const Profile::Timer timer(buffers.profile, Profile::decisions);
    decide_contacts<Rules>(blocks, all, model.settings, dt, *buffers.workers);
  }
  Extremes touching;
  {
    const Profile::Timer timer(buffers.profile, Profile::forces);
    touching = evaluate_pairs(blocks, all, model.settings, dt, *buffers.workers);
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
Displacement step_by_pairs(Model& model, SearchBuffers& buffers) {
  const Displacement moved = advance_by_pairs<Rules>(model, buffers, true, 0.0);
  catch_up_pairs(model, buffers);
  return moved;
}

}  // namespace blocks::dynamics
