// Copies the decisions that a run keeps to a model and back, for checkpoints.
#pragma once

#include "dynamics/workspace.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns the decisions of the last step. The arrays of contacts must be up to date,
/// except for pieces of blocks that have split.
KeptDecisions kept_decisions(const Workspace& work);

/// Brings the workspace to the state in which the decisions of the model were kept, and
/// takes them out of the model. The list of contacts must be that of the same step.
void restore_decisions(Model& model, Workspace& work);

}  // namespace blocks::dynamics
