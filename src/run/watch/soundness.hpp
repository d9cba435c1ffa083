// Checks whether the result of a step can still be trusted.
#pragma once

#include <string>

#include "dynamics/step.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Half the least distance of an edge from the centroid of its convex block, [L];
/// infinite without convex blocks. A spring that is pressed in further has no physical
/// meaning.
double half_depth(const Blocks& blocks);

/// Whether a step must be examined by unsound(). If false, the step is sound.
bool may_be_unsound(const Settings& settings, const dynamics::StepResult& moved,
                    double half_depth);

/// The reason why the last step is unsound; empty if it is sound. A step is unsound if
/// one of these holds:
/// - Some position is no longer a number.
/// - A corner moved by more than ctol and half_depth, so that it may have passed
///   through a block.
/// - A contact is pressed in by more than half the depth of the centroid of the edge's
///   block, which is convex.
/// - A contact is pressed in by more than a quarter of the extent of the corner's block
///   across the edge or plane. For an edge, that block must be convex.
///
/// If the strongest spring exceeds Kn times half_depth, the springs of the contact list
/// must be up to date. Kn is that of STIFF. For contacts with the law of a joint,
/// moved.strongest is the force that would press in a contact of STIFF as far.
std::string unsound(const Model& model, const dynamics::StepResult& moved,
                    double half_depth);

}  // namespace blocks::run
