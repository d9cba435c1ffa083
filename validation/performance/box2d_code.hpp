// Box2D 2.4.1 of Debian, which a user might choose instead. It uses single precision
// and an iterative solver of impulses, without springs.
#pragma once

#include <memory>

#include "contestant.hpp"
#include "model/model.hpp"

namespace blocks::bench {

/// Returns whether Box2D was found when this was compiled.
bool has_box2d();

/// Returns a code with the blocks, gravity, friction and symmetry planes of the model.
/// It steps by 1/60 [T] with 8 velocity and 3 position iterations. Sleeping and
/// continuous collision are off. Its work is counted in body-iterations, 8 per step.
/// Returns null without Box2D and for a model with loads.
std::unique_ptr<Contestant> box2d_code(const Model& start);

}  // namespace blocks::bench
