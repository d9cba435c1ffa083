// One time step: the six calls of docs/architecture.md#one-step.
#pragma once

#include <limits>

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

/// Makes a step with readings.
StepResult step(Model& model, Workspace& work);

}  // namespace blocks::dynamics
