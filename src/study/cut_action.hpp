// Random convex blocks that are thrown at a domain, slid, rolled, pressed or wedged.
#pragma once

#include <string>
#include <vector>

#include "study/cut_domain.hpp"
#include "study/draws.hpp"

namespace blocks::study {

/// A block at the start of a run. Its size is 1, its largest speed is about 1, and the
/// deepest overlap that this speed causes is `overlap`.
struct CutAction {
  std::string kind;           ///< "thrown", "slid", "rolled", "pressed", "wedged"
  Polygon block;              ///< [L] clockwise, outside of the domain
  double overlap = 0.0;       ///< [L] that scales speed and load, 1e-5 to 1e-2
  double rest_overlap = 0.0;  ///< [L] the load on one spring: F / K
  Vec2 velocity = {0, 0};
  double spin = 0.0;
  Vec2 load = {0, -1};  ///< direction of gravity, a unit vector
  double friction = 0.0, damping = 0.0;
};

/// Draws a block and what it does. A block is wedged only into a domain that has a
/// notch.
CutAction draw_action(Draws& draw, const CutDomain& domain);

}  // namespace blocks::study
