#include "dynamics/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks::dynamics {

Vec2 extent(const Blocks& blocks, int b) {
  const auto corners =
      blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  return corners.rowwise().maxCoeff() - corners.rowwise().minCoeff();
}

double least_width(const Blocks& blocks, int b) {
  const auto corners =
      blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  const int n = static_cast<int>(corners.cols());
  // The least width is at right angles to a side of the convex hull, which joins two
  // corners.
  const int reach = blocks.convex[b] ? 1 : n - 1;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i)
    for (int k = 1; k <= reach; ++k) {
      const Vec2 along = (corners.col((i + k) % n) - corners.col(i)).normalized();
      const Vec2 normal(-along.y(), along.x());
      const Eigen::RowVectorXd across =
          normal.transpose() * (corners.colwise() - blocks.centroid.col(b));
      least = std::min(least, across.maxCoeff() - across.minCoeff());
    }
  return least;
}

double safe_fraction(double damping, int contacts) {
  const double n = contacts;
  return (std::sqrt(1.0 + 3.0 * n * damping * damping) - damping * std::sqrt(3.0 * n)) /
         std::sqrt(6.0 * n);
}

TimeStep choose_time_step(const Model& model) {
  const Settings& settings = model.settings;
  const Blocks& blocks = model.blocks;
  const double stiffness =
      std::max(settings.normal_stiffness, settings.shear_stiffness);

  TimeStep best{std::numeric_limits<double>::infinity(), -1, blocks.size(), false};
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b))
      continue;
    const double dt = settings.fraction * 2.0 * std::sqrt(blocks.mass[b] / stiffness);
    if (dt < best.dt)
      best = {dt, b, blocks.size(), false};
  }
  if (settings.rigid)
    return best;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b))
      continue;
    const Material& material = settings.materials.at(blocks.material[b]);
    const double dt =
        0.5 * least_width(blocks, b) * std::sqrt(material.density / material.c11());
    if (dt < best.dt)
      best = {dt, b, blocks.size(), true};
  }
  return best;
}

}  // namespace blocks::dynamics
