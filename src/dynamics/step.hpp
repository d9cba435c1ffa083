// One time step: the numbered list of calls of docs/architecture.md.
#pragma once

#include "dynamics/contact_forces.hpp"
#include "dynamics/contact_search.hpp"
#include "dynamics/motion.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Makes a model ready to step after cards have acted: first boxing, time step,
/// dashpots. Call before the first step and whenever cards changed the model between
/// steps.
void prepare(Model& model);

/// Advances the model by one step of model.time_step.dt. No input or output.
/// Returns what moved; not finite: the state is lost and the run must stop.
Displacement step(Model& model, SearchBuffers& buffers);

/// The same for a step after which nothing but corners and velocities is read: contacts
/// and the applied stress of rigid blocks stay behind until the next step(), which must
/// come before anything else reads or changes the model.
Displacement advance(Model& model, SearchBuffers& buffers);

/// The two ends of a step, for whoever finds the contact forces in another way
/// (src/study): forces to zero before they are found; planes, loads, motion and domain
/// after.
void clear_forces(Blocks& blocks);
Displacement move(Model& model, SearchBuffers& buffers, const Extremes& touching);

/// Writes what the contacts did in a step that found everything into the model.
void tell(Model& model, SearchBuffers& buffers);

}  // namespace blocks::dynamics
