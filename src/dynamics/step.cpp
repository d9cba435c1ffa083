#include "dynamics/step.hpp"

#include <algorithm>

#include "dynamics/domain.hpp"
#include "dynamics/energy/energy.hpp"
#include "dynamics/kinetic_damping.hpp"
#include "dynamics/loads/loads.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/preparation/mass_scaling.hpp"
#include "dynamics/preparation/time_step.hpp"
#include "dynamics/servo.hpp"
#include "dynamics/update_pairs.hpp"
#include "model/numbering.hpp"

namespace blocks::dynamics {

void prepare(Model& model) {
  model.kept = {};          // cards may have changed the blocks
  end_mass_scaling(model);  // of a SOLVE that was not finished
  fix_outside_domain(model);
  if (model.time_step.blocks != model.blocks.size()) {
    count_time_from_here(model);
    model.time_step = choose_time_step(model);
    model.order = order_if_worthwhile(model.blocks);
  }
  // Cards may have freed, fixed or pushed blocks, which is no peak of the energy.
  model.last_kinetic_energy = 0.0;
  begin_energy(model);
  model.started = true;
}

double time_after_step(const Model& model) {
  const auto steps = static_cast<double>(model.steps + 1 - model.step_origin);
  return model.time_origin + steps * model.time_step.dt;
}

StepResult advance(Model& model, Workspace& work, bool readings, double alarm) {
  Blocks& blocks = model.blocks;
  const Settings& settings = model.settings;
  const double dt = model.time_step.dt;

  // 1. Pairs of blocks that may touch. Reads blocks, springs; writes pairs, arrays.
  update_pairs(model, work);

  // 2. Contacts that may act. Reads blocks, motion bounds; writes decisions, slots.
  Profile::Timer timer(work.profile, Profile::decisions);
  decide_contacts(model, work);

  // 3. Contact forces. Reads blocks, springs; writes springs, forces of pairs, and the
  // list if `reads`.
  timer.next(Profile::forces);
  ContactBatches& batches = work.contacts.batches;
  batches.has_account = model.energy.kept;
  const Extremes at_contacts = find_contact_forces(model, work);
  const bool reads = readings || !(at_contacts.spring <= alarm);
  if (model.energy.kept)
    count_forces(model, work.contacts, work.springs.list_is_current(), *work.workers,
                 work.energy);
  if (reads)
    take_readings(model, work);
  batches.advance_springs();
  work.springs.arrays_changed();
  if (reads)
    list_contacts(model, work, true);

  // 4. Planes and loads. Reads blocks, time; writes block forces, applied stress.
  timer.next(Profile::motion);
  const bool loaded = has_loads(model);
  const Extremes at_planes =
      loaded ? add_loads(model, work.split.blocks, *work.workers) : Extremes{};
  if (!model.servos.empty())
    control_servos(model, work.contacts);

  // 5. Motion. Reads forces; writes velocities, strain, stress, corners, motion bounds.
  const Vec2 gravity = settings.gravity_at(model.time);
  const bool stopped = settings.kinetic_damping &&
                       stop_at_peak(model, *work.workers, work.energy.block_tallies);
  double* const damped = model.energy.kept ? work.energy.damped.data() : nullptr;
  const Displacement moved =
      move_blocks(blocks, settings,
                  {dt, stopped ? 0.5 * dt : dt, gravity, loaded, damped}, work.contacts,
                  work.decisions.bounds, work.split.blocks, *work.workers, work.moved);
  if (settings.rigid && reads)
    blocks.applied.array().rowwise() /= blocks.area.transpose().array();
  model.time = time_after_step(model);
  ++model.steps;
  if (model.energy.kept)
    count_motion(model, gravity, stopped, *work.workers, work.energy);

  // 6. Blocks outside the domain, next search. Reads corners; writes fixities, search.
  update_domain(model, moved.left_domain, moved.largest);
  if (moved.left_domain)
    work.decisions.expire_exact();  // a block that is fixed now may be no third part
  if (model.energy.kept && moved.left_domain)
    count_fixed(model, work.contacts, *work.workers, work.energy);

  Extremes all = at_contacts;
  all.include(at_planes);
  model.worst_overlap = std::max(model.worst_overlap, all.overlap);
  return {moved.largest, moved.block, moved.finite, all.spring};
}

StepResult step(Model& model, Workspace& work) { return advance(model, work, true); }

void catch_up(Model& model, Workspace& work) {
  if (!work.springs.list_is_current())
    list_contacts(model, work, false);
}

}  // namespace blocks::dynamics
