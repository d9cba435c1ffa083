// Debian's Box2D 2.4.1, what a user would pick instead: single precision, an iterative
// solver of impulses, no springs.
#pragma once

#include <memory>

#include "contestant.hpp"
#include "model/model.hpp"

namespace blocks::bench {

/// Returns whether Box2D was found when this was compiled.
bool has_box2d();

/// The model's blocks, gravity, friction and symmetry planes, without loads, stepped by
/// 1/60 [T] with 8 velocity and 3 position iterations. Nothing sleeps, and no time of
/// impact is sought. Its work is counted in body-iterations, 8 a step. Null without
/// Box2D and for a model with loads.
std::unique_ptr<Contestant> box2d_code(const Model& start);

}  // namespace blocks::bench
