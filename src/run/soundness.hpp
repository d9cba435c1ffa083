// Whether what a step made can still be trusted.
#pragma once

#include <string>

#include "dynamics/step.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Half the least distance of an edge from the centroid of its convex block, [L];
/// infinite without convex blocks. A spring pressed in by more holds no real force.
double half_depth(const Blocks& blocks);

/// Whether a step has to be judged. False: it is sound.
bool may_be_unsound(const Settings& settings, const dynamics::StepResult& moved,
                    double half_depth);

/// Why the step just made is unsound, or "": some position is no longer a number; a
/// corner moved by more than ctol and half_depth, so that it may have passed through a
/// block; or a contact of a convex block is pressed in by more than half of what the
/// block is deep, or a quarter of what the other measures across the edge or plane.
/// Springs of the list must be up to date if the strongest exceeds Kn times half_depth.
std::string unsound(const Model& model, const dynamics::StepResult& moved,
                    double half_depth);

}  // namespace blocks::run
