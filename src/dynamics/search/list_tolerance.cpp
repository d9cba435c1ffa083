#include "dynamics/search/list_tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace blocks::dynamics {

double list_tolerance(const Model& model) {
  constexpr double steps_of_list = 250.0, part_of_size = 0.1;
  constexpr int many_blocks = 1 << 17;  // with more blocks, the list is kept short
  const double ctol = model.settings.contact_tolerance;
  const Blocks& blocks = model.blocks;
  if (blocks.size() == 0 || blocks.size() > many_blocks)
    return ctol;
  double speed = 0.0, spin = 0.0, small = 0.0;
  for (int b = 0; b < blocks.size(); ++b) {
    const double size = std::sqrt(blocks.area[b]);
    small += 1.0 / size;  // the harmonic mean: small if most blocks are small
    // Fixed blocks that are not driven have no velocity and spin.
    speed = std::max(speed, blocks.velocity.col(b).squaredNorm());
    spin = std::max(spin, size * std::abs(blocks.spin[b]));
  }
  const double size = blocks.size() / small;
  const double way =
      steps_of_list * model.time_step.dt * (std::sqrt(speed) + 0.5 * spin);
  return std::max(ctol, std::min(part_of_size * size, way));  // CTOL if `way` is NaN
}

}  // namespace blocks::dynamics
