#include "dynamics/preparation/quiet.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "dynamics/energy/block_energy.hpp"
#include "dynamics/loads/quiet_sides.hpp"
#include "dynamics/preparation/in_situ.hpp"

namespace blocks::dynamics {
namespace {

/// Divides the force and the moment about the centroid between the ends of a side, as a
/// traction that is linear along the side.
void hold(const Blocks& blocks, QuietSide& quiet, const Vec2& force, double moment) {
  const auto [c1, c2] = ends_of(blocks, quiet);
  const Vec2 arm1 = blocks.present_arm(c1), arm2 = blocks.present_arm(c2);
  const Vec2 along = arm2 - arm1, normal(-along.y(), along.x());
  const double couple = moment - geometry::cross(0.5 * (arm1 + arm2), force);
  const Vec2 more = couple / along.squaredNorm() * normal;
  quiet.first += 0.5 * force - more;
  quiet.second += 0.5 * force + more;
}

}  // namespace

double decay_rate(const Blocks& blocks, bool rigid, int b,
                  const std::vector<QuietSide>& sides) {
  // Motions are v1, v2, spin and the strain rates 11, 22, 12. Masses and dashpots are
  // symmetric matrices on them.
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
  const int n = rigid ? 3 : 6;
  const BlockMasses block_masses = masses_of(blocks, b, rigid);
  Matrix masses = Matrix::Zero(n, n), dashpots = Matrix::Zero(n, n);
  masses.diagonal().head<3>() << block_masses.mass, block_masses.mass,
      block_masses.inertia;
  if (!rigid) {
    const auto [m11, m22, m12] = block_masses.strain;
    masses.bottomRightCorner<3, 3>() << m11, 0, m12, 0, m22, m12, m12, m12, m11 + m22;
  }
  for (const QuietSide& quiet : sides) {
    if (quiet.block != b)
      continue;
    const Dashpots dashpot = dashpots_of(blocks, quiet);
    const auto [c1, c2] = ends_of(blocks, quiet);
    for (const int corner : {c1, c2}) {
      const Vec2 arm = blocks.present_arm(corner);
      const double x = arm.x(), y = arm.y();
      Eigen::Matrix<double, 2, 6> motion;
      motion << 1, 0, -y, x, 0, y, 0, 1, x, 0, y, x;
      const Eigen::VectorXd normal = motion.leftCols(n).transpose() * dashpot.p;
      const Eigen::VectorXd along = motion.leftCols(n).transpose() * dashpot.a;
      dashpots += dashpot.normal * normal * normal.transpose();
      dashpots += dashpot.along * along * along.transpose();
    }
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solved(dashpots, masses,
                                                                Eigen::EigenvaluesOnly);
  return solved.eigenvalues().maxCoeff();
}

Vec2 make_quiet(Model& model, const QuietSide& quiet) {
  Blocks& blocks = model.blocks;
  const int b = quiet.block;
  std::vector<QuietSide>& sides = model.loads.quiet_sides;
  const auto same =
      std::find_if(sides.begin(), sides.end(), [&](const QuietSide& other) {
        return other.block == b && other.side == quiet.side;
      });
  QuietSide& side = same == sides.end() ? sides.emplace_back(quiet) : *same;
  side.cp = quiet.cp, side.cs = quiet.cs;
  if (blocks.is_free(b))
    return {0, 0};
  free_in_ground(model, {b});
  const Vec2 weight = blocks.mass[b] * model.settings.gravity_at(model.time);
  const Vec2 held = Vec2::Zero() - Vec2(blocks.force.col(b)) - weight;
  const QuietSide before = side;
  hold(blocks, side, held, -blocks.moment[b]);
  if (!model.settings.rigid) {
    // The next step finds these sums (9) again.
    Eigen::Vector4d applied = blocks.applied.col(b) * blocks.area[b];
    const auto [c1, c2] = ends_of(blocks, side);
    const auto include = [&](const Vec2& arm, const Vec2& f) {
      applied += Eigen::Vector4d(f.x() * arm.x(), f.x() * arm.y(), f.y() * arm.x(),
                                 f.y() * arm.y());
    };
    include(blocks.present_arm(c1), side.first - before.first);
    include(blocks.present_arm(c2), side.second - before.second);
    applied /= blocks.area[b];
    const double shear = 0.5 * (applied[1] + applied[2]);
    blocks.stress.col(b) = Eigen::Vector4d(applied[0], shear, shear, applied[3]);
  }
  return held;
}

}  // namespace blocks::dynamics
