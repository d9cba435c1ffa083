#include "dynamics/domain.hpp"

namespace blocks::dynamics {

int fix_outside_domain(Model& model) {
  Blocks& blocks = model.blocks;
  const Settings& settings = model.settings;
  int fixed = 0;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b))
      continue;
    const auto corners =
        blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
    const Vec2 lower = corners.rowwise().minCoeff(),
               upper = corners.rowwise().maxCoeff();
    if ((lower.array() >= settings.lower.array()).all() &&
        (upper.array() <= settings.upper.array()).all())
      continue;
    blocks.fix(b, Fixity::left_domain);
    model.exits.push_back({b, model.time});
    model.search.current = false;  // its mass is infinite now
    ++fixed;
  }
  return fixed;
}

void update_domain(Model& model, bool left_domain, double largest) {
  if (left_domain)
    fix_outside_domain(model);
  SearchState& search = model.search;
  search.left -= largest;
  if (search.left < 0.0)
    search.current = false, search.left = 0.0;
}

}  // namespace blocks::dynamics
