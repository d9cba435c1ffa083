#include "dynamics/step.hpp"

#include "dynamics/contacts/contact_list.hpp"
#include "dynamics/mass_scaling.hpp"
#include "dynamics/time_step.hpp"
#include "model/numbering.hpp"

namespace blocks::dynamics {

void prepare(Model& model) {
  model.kept = {};          // cards may have changed the blocks
  end_mass_scaling(model);  // of a SOLVE that was not finished
  fix_outside_domain(model);
  if (model.time_step.blocks != model.blocks.size()) {
    // The times of later steps are counted from here.
    model.time_origin = model.time;
    model.step_origin = model.steps;
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
  return advance_by(ContactRules(), model, work, readings, alarm);
}

StepResult step(Model& model, Workspace& work) {
  return step_by(ContactRules(), model, work);
}

void catch_up(Model& model, Workspace& work) {
  if (work.springs.list_is_current())
    return;
  const ContactArrays& arrays = work.contacts;
  list_acting(
      arrays, work.split, *work.workers, work.forces.first_contact, model.contacts,
      model.joint_states,
      [&](int slot, Contact& contact) {
        contact.normal_elastic = arrays.batches.at(slot, &SpringRow::normal_elastic);
        contact.shear_elastic = arrays.batches.at(slot, &SpringRow::shear_elastic);
        contact.normal_force = contact.shear_force = contact.overlap = 0.0;
      },
      [&](int slot, JointState& state) { state = arrays.joint_at(slot); });
  if (model.settings.rigid)
    model.blocks.applied.setZero();
  work.springs.both_agree();
}

}  // namespace blocks::dynamics
