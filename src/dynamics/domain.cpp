#include "dynamics/domain.hpp"

#include "model/drives.hpp"

namespace blocks::dynamics {

bool is_inside_domain(const Blocks& blocks, int b, const Settings& settings) {
  const auto corners =
      blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  return (corners.rowwise().minCoeff().array() >= settings.lower.array()).all() &&
         (corners.rowwise().maxCoeff().array() <= settings.upper.array()).all();
}

int fix_outside_domain(Model& model) {
  Blocks& blocks = model.blocks;
  int fixed = 0;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!(blocks.is_free(b) || blocks.is_driven(b)) ||
        is_inside_domain(blocks, b, model.settings))
      continue;
    blocks.fix(b, Fixity::left_domain);
    end_drive(model, b);
    model.exits.push_back({b, model.time});
    model.search.invalidate();  // the block now has infinite mass
    ++fixed;
  }
  return fixed;
}

void update_domain(Model& model, bool left_domain, double largest) {
  if (left_domain)
    fix_outside_domain(model);
  model.search.spend(largest);
}

}  // namespace blocks::dynamics
