#include "post/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace blocks::post {

Quantity quantity(const std::string& name, const Frame& now, const Frame& first) {
  const auto stress = [&](int row) -> Eigen::VectorXd { return now.stress.row(row); };
  if (name == "speed")
    return {"speed", now.velocity.colwise().norm(), false};
  if (name == "displacement") {
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(now.centroid.cols());
    const auto common = std::min(now.centroid.cols(), first.centroid.cols());
    moved.head(common) =
        (now.centroid.leftCols(common) - first.centroid.leftCols(common))
            .colwise()
            .norm();
    return {"displacement", moved, false};
  }
  if (name == "rotation")
    return {"rotation (degrees)", now.angle * (180.0 / 3.14159265358979323846), true};
  if (name == "s11")
    return {"stress 11", stress(0), true};
  if (name == "s12")
    return {"stress 12", stress(1), true};
  if (name == "s22")
    return {"stress 22", stress(3), true};
  if (name == "p1" || name == "p2") {
    const Eigen::ArrayXd mean = 0.5 * (stress(0) + stress(3)).array();
    const Eigen::ArrayXd half = 0.5 * (stress(0) - stress(3)).array();
    const Eigen::ArrayXd radius = (half.square() + stress(1).array().square()).sqrt();
    const double sign = name == "p1" ? 1.0 : -1.0;
    return {name == "p1" ? "principal stress 1" : "principal stress 2",
            (mean + sign * radius).matrix(), true};
  }
  throw std::runtime_error(
      "there is no quantity '" + name +
      "': choose material, speed, displacement, rotation, s11, s12, "
      "s22, p1 or p2");
}

}  // namespace blocks::post
