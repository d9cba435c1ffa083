// One time step: the six calls of docs/architecture.md#one-step.
#pragma once

#include <algorithm>
#include <limits>

#include "dynamics/contact_forces.hpp"
#include "dynamics/decisions/decide_contacts.hpp"
#include "dynamics/domain.hpp"
#include "dynamics/energy.hpp"
#include "dynamics/kinetic_damping.hpp"
#include "dynamics/loads.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/servo.hpp"
#include "dynamics/update_pairs.hpp"
#include "dynamics/workspace.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// The outcome of a step. If it is not `finite`, the state is unusable and the run must
/// stop.
struct StepResult {
  double largest = 0.0;  ///< [L] Displacement::largest
  int block = -1;        ///< the first block that moved by `largest`
  bool finite = true;    ///< whether all corners are finite numbers
  /// [F] largest elastic normal force, planes included. Contacts with the law of a
  /// joint count with the force that would press in a contact of STIFF as far.
  double strongest = 0.0;
};

/// Prepares a model for stepping after cards have acted. Fixes blocks outside the
/// domain. If blocks have been added, also chooses the time step and, for the Stepper,
/// the order of the blocks. Call it before the first step and whenever cards have
/// changed the model between steps.
void prepare(Model& model);

/// Returns the model's time after one more step.
double time_after_step(const Model& model);

/// Advances the model by one step of model.time_step.dt, without input or output. After
/// a step without readings the list of contacts is out of date until catch_up(), which
/// must be called before anything else reads or changes the model. Forces and overlaps
/// of contacts and the applied stress of rigid blocks are computed only with
/// `readings`, or if the spring of a contact between blocks exceeds `alarm` [F].
/// Otherwise they are 0.
StepResult advance(Model& model, Workspace& work, bool readings,
                   double alarm = std::numeric_limits<double>::infinity());
/// Brings the list of contacts up to date.
void catch_up(Model& model, Workspace& work);

/// Makes a step with readings and brings the list of contacts up to date.
StepResult step(Model& model, Workspace& work);

/// Makes the step with any contact rule that has the members of ContactRules.
template <class Rules>
StepResult advance_by(const Rules& rules, Model& model, Workspace& work, bool readings,
                      double alarm) {
  Blocks& blocks = model.blocks;
  const Settings& settings = model.settings;
  const double dt = model.time_step.dt;

  // 1. Pairs of blocks that may touch. Reads blocks, springs; writes pairs, arrays.
  update_pairs(model, work);

  // 2. Contacts that may act. Reads blocks, motion bounds; writes decisions, slots.
  Profile::Timer timer(work.profile, Profile::decisions);
  decide_contacts(rules, blocks, settings, work.parts, work.index, work.decisions,
                  work.contacts, work.split, *work.workers, work.deciding,
                  work.forces.transfer.released);
  work.count_exact_calls();

  // 3. Contact forces. Reads blocks, springs; writes springs, forces of pairs, and the
  // list if `reads`.
  timer.next(Profile::forces);
  work.contacts.batches.has_account = model.energy.kept;
  const Extremes at_contacts =
      find_contact_forces(blocks, settings, dt, work.contacts, Rules::transfers_springs,
                          work.split, *work.workers, work.forces);
  for (const int pair : work.forces.broken)
    work.decisions.expire(pair);
  const bool reads = readings || !(at_contacts.spring <= alarm);
  if (model.energy.kept)
    count_forces(model, work.contacts, work.springs.list_is_current(), work.split,
                 *work.workers, work.energy);
  work.springs.arrays_changed();
  if (reads) {
    read_contacts(blocks, model.contacts, model.joint_states, settings, dt,
                  work.contacts, work.split, *work.workers, work.forces);
    work.springs.both_agree();
  }

  // 4. Planes and loads. Reads blocks, time; writes block forces, applied stress.
  timer.next(Profile::motion);
  const bool loaded = has_loads(model);
  const Extremes at_planes =
      loaded ? add_loads(model, work.split.blocks, *work.workers) : Extremes{};
  if (!model.servos.empty())
    control_servos(model, work.contacts);

  // 5. Motion. Reads forces; writes velocities, strain, stress, corners, motion bounds.
  work.contacts.batches.advance_springs();
  const Vec2 gravity = settings.gravity_at(model.time);
  const bool stopped = settings.kinetic_damping &&
                       stop_at_peak(model, work.split, *work.workers,
                                    work.energy.block_tallies, work.energy.shares);
  double* const damped = model.energy.kept ? work.energy.damped.data() : nullptr;
  const Displacement moved = move_blocks(
      blocks, settings, {dt, stopped ? 0.5 * dt : dt, gravity, loaded, damped},
      work.contacts, model.drives, work.decisions.bounds, work.split.blocks,
      *work.workers, work.moved);
  if (settings.rigid && reads)
    blocks.applied.array().rowwise() /= blocks.area.transpose().array();
  model.time = time_after_step(model);
  ++model.steps;
  if (model.energy.kept)
    count_motion(model, gravity, stopped, work.split, *work.workers, work.energy);

  // 6. Blocks outside the domain, next search. Reads corners; writes fixities, search.
  update_domain(model, moved.left_domain, moved.largest);
  if (moved.left_domain)
    work.decisions.expire_exact();  // a block that is fixed now may be no third part
  if (model.energy.kept && moved.left_domain)
    count_fixed(model, work.contacts, work.split, *work.workers, work.energy);

  Extremes all = at_contacts;
  all.include(at_planes);
  model.worst_overlap = std::max(model.worst_overlap, all.overlap);
  return {moved.largest, moved.block, moved.finite, all.spring};
}

/// The same with any contact rule that has the members of ContactRules.
template <class Rules>
StepResult step_by(const Rules& rules, Model& model, Workspace& work) {
  const StepResult made = advance_by(rules, model, work, true, 0.0);
  catch_up(model, work);
  return made;
}

}  // namespace blocks::dynamics
