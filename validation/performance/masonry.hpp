// Shared by the scenes of bricks and of polygons: a trough and the settings.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace blocks::bench {

/// Returns a rectangle of rock.
NewBlock box(double left, double bottom, double right, double top,
             Fixity fixity = Fixity::free);

/// Returns the fixed floor and sides around 0 <= x <= width, 0 <= y <= top [L].
std::vector<NewBlock> trough(double width, double top);

/// Returns a model of rigid blocks with gravity 9.81, friction 0.6, damping 0.5 and the
/// stiffness [F/L] in both directions. The domain extends from -2 to width + 2 and from
/// -2 to height + 2 [L]. Its boxes are 1 wide, in boxes_y rows.
Model masonry(const std::string& title, const std::vector<NewBlock>& blocks,
              double width, double height, int boxes_y, double stiffness);

constexpr double rock_density = 2500.0;

}  // namespace blocks::bench
