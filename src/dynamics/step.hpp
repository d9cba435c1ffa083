// One time step: the numbered list of calls of docs/architecture.md.
#pragma once

#include <limits>

#include "dynamics/contact_search.hpp"
#include "dynamics/motion.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Makes a model ready to step after cards have acted: first boxing, time step, order
/// (which step() and advance() leave to the Stepper). Call before the first step and
/// whenever cards changed the model between steps.
void prepare(Model& model);

/// The model's time after one step more.
double time_after_step(const Model& model);

/// Advances the model by one step of model.time_step.dt. No input or output.
/// Returns what moved; not finite: the state is lost and the run must stop.
Displacement step(Model& model, SearchBuffers& buffers);

/// The same, but the list of contacts stays behind until catch_up(), which must come
/// before anything else reads or changes the model; without `readings` forces and
/// overlaps of contacts and the applied stress of rigid blocks are not found in this
/// step, and are 0 then, unless a contact is pressed by more than `alarm`, [F].
Displacement advance(Model& model, SearchBuffers& buffers, bool readings,
                     double alarm = std::numeric_limits<double>::infinity());
void catch_up(Model& model, SearchBuffers& buffers);

/// The end of a step, once the contact forces are known: symmetry planes, loads, motion
/// and domain. `acting` holds the contacts.
Displacement move(Model& model, SearchBuffers& buffers, ActingLanes& acting,
                  const Extremes& touching);

}  // namespace blocks::dynamics
