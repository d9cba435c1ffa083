// Rock that joints have cut into blocks.
#pragma once

#include "model/model.hpp"

namespace blocks::bench {

enum class Cut { two_sets, voronoi };

/// How the rock moves. At rest it stands between two walls; it creeps while one of them
/// recedes at 0.02 [L/T]; it fails if this wall is absent.
enum class Support { walls, receding_wall, one_wall };

/// Returns a rectangle of about this many blocks, 3 : 2, of area 1 each, cut by two sets
/// at right angles that dip by 60 and 30 degrees, or into Voronoi cells. It stands on
/// fixed blocks 4 wide, under gravity 9.81, with friction 0.6 and damping 0.3, and with
/// local damping 0.7 unless it fails. With laws, the same friction is that of joints
/// with stiffnesses of their own. Throws std::runtime_error if the deck has errors.
Model cut_rock(Cut cut, int blocks, Support support, bool laws = false);

}  // namespace blocks::bench
