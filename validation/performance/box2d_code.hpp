// Debian's Box2D 2.4.1, what a user would pick instead: single precision, an iterative
// solver of impulses, no springs.
#pragma once

#include <memory>

#include "contestant.hpp"
#include "model/model.hpp"

namespace blocks::bench {

/// The model's blocks, gravity and friction as they stand, stepped by 1/60 [T] with 8
/// velocity and 3 position iterations; nothing sleeps, and no time of impact is sought.
/// Its work is counted in body-iterations, 8 a step. Null where Box2D was not found
/// when this was compiled.
std::unique_ptr<Contestant> box2d_code(const Model& start);

}  // namespace blocks::bench
