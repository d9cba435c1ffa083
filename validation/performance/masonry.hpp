// What the scenes of bricks and of polygons have in common: a trough, and settings.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace blocks::bench {

/// A rectangle of rock.
NewBlock box(double left, double bottom, double right, double top,
             Fixity fixity = Fixity::free);

/// The fixed floor and sides around x 0 to width, y 0 to top [L].
std::vector<NewBlock> trough(double width, double top);

/// Rigid blocks under gravity 9.81, friction 0.6, damping 0.5; stiffness [F/L] in both
/// directions. The domain is -2 to width + 2, -2 to height + 2 [L], in boxes 1 wide and
/// boxes_y of them high.
Model masonry(const std::string& title, const std::vector<NewBlock>& blocks,
              double width, double height, int boxes_y, double stiffness);

constexpr double rock_density = 2500.0;

}  // namespace blocks::bench
