// The stress in the ground (INSITU, docs/rest.md#stress-in-the-ground).
#pragma once

#include <Eigen/Core>

namespace blocks {

/// A stress that is linear in y, [F/L^2], tension positive.
struct StressField {
  double xx = 0.0, yy = 0.0, xy = 0.0;                    ///< [F/L^2] at y = 0
  double per_y_xx = 0.0, per_y_yy = 0.0, per_y_xy = 0.0;  ///< [F/L^3] gradients

  /// Returns the tensor at a height, [F/L^2].
  Eigen::Matrix2d at(double y) const {
    const double shear = xy + y * per_y_xy;
    Eigen::Matrix2d stress;
    stress << xx + y * per_y_xx, shear, shear, yy + y * per_y_yy;
    return stress;
  }
};

}  // namespace blocks
