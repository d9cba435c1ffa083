// INSITU at symmetry planes.
#pragma once

#include <functional>

#include "dynamics/preparation/in_situ.hpp"

namespace blocks::dynamics {

/// Loads the sides of the chosen free blocks that are flush with a symmetry plane by
/// the field of INSITU, like faces. The spring of each corner becomes its part of the
/// force, and an offset keeps it acting. A plane carries neither tension nor shear; the
/// report counts corners that need them.
void load_planes(Model& model, const std::function<bool(int block)>& chosen,
                 InSituReport& report);

/// Returns whether a free block has a side on the plane, within the tolerance of
/// INSITU.
bool has_sides_on(const Model& model, const Plane& plane);

}  // namespace blocks::dynamics
