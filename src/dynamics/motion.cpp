#include "dynamics/motion.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/time_step.hpp"

namespace blocks::dynamics {
namespace {

/// Orthogonal to round-off and free of trigonometry: h = spin dt / 2 (rule 6).
Eigen::Matrix2d cayley_rotation(double turn) {
  const double h = 0.5 * turn, scale = 1.0 / (1.0 + h * h);
  const double c = (1.0 - h * h) * scale, s = 2.0 * h * scale;
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

/// R s R^T of a symmetric tensor stored as 11, 12, 21, 22.
void rotate_symmetric(Eigen::Ref<Eigen::Vector4d> s, const Eigen::Matrix2d& r) {
  const Eigen::Matrix2d t =
      r * (Eigen::Matrix2d() << s[0], s[1], s[1], s[3]).finished() * r.transpose();
  const double shear = 0.5 * (t(0, 1) + t(1, 0));
  s << t(0, 0), shear, shear, t(1, 1);
}

}  // namespace

void Displacement::include(const Displacement& others) {
  // the same block in whatever order parts come
  if (others.largest > largest || (others.largest == largest && others.block < block))
    largest = others.largest, block = others.block;
  way = std::max(way, others.way);
  finite = finite && others.finite;
  left_domain = left_domain || others.left_domain;
}

void sum_contact_forces(Blocks& blocks, const ContactGroups& groups, BlockRange range) {
  for (int b = range.first; b < range.last; ++b) {
    double x = blocks.force(0, b), y = blocks.force(1, b), moment = blocks.moment[b];
    groups.each_lane_of(b, [&](unsigned lane, bool low) {
      const PairForce& of = groups.lanes.forces[lane];
      if (low)
        x += of.fx, y += of.fy, moment += of.moment_low;
      else
        x -= of.fx, y -= of.fy, moment += of.moment_high;
    });
    blocks.force(0, b) = x, blocks.force(1, b) = y;
    blocks.moment[b] = moment;
  }
}

void finish_applied_stress(Blocks& blocks, const ContactGroups& groups,
                           BlockRange range) {
  for (int b = range.first; b < range.last; ++b) {
    Eigen::Vector4d sum = blocks.applied.col(b);
    groups.each_lane_of(b, [&](unsigned lane, bool low) {
      const PairStress& of = groups.lanes.stresses[lane];
      sum += Eigen::Map<const Eigen::Vector4d>(low ? of.low : of.high);
    });
    blocks.applied.col(b) = sum / blocks.area[b];
  }
}

void update_velocities(Blocks& blocks, BlockRange range, const Vec2& gravity,
                       double dt) {
  for (int b = range.first; b < range.last; ++b) {
    if (!blocks.is_free(b))
      continue;
    blocks.velocity.col(b) += dt * (blocks.force.col(b) / blocks.mass[b] + gravity);
    blocks.spin[b] += dt * (blocks.moment[b] / blocks.inertia[b]);
  }
}

void update_strain_rates(Blocks& blocks, BlockRange range, double dt) {
  for (int b = range.first; b < range.last; ++b) {
    if (!blocks.is_free(b))
      continue;
    const Vec2 l = extent(blocks, b);
    const double mass_per_area = 0.25 * blocks.mass[b] / blocks.area[b];
    const double m11 = l.x() * l.x() * mass_per_area;
    const double m22 = l.y() * l.y() * mass_per_area;
    const auto applied = blocks.applied.col(b), internal = blocks.stress.col(b);
    auto rate = blocks.strain_rate.col(b);
    const double shear = 0.5 * (applied[1] + applied[2]) - internal[1];
    rate[0] += dt * (applied[0] - internal[0]) / m11;
    rate[1] += dt * shear / (0.5 * (m11 + m22));
    rate[2] = rate[1];
    rate[3] += dt * (applied[3] - internal[3]) / m22;
  }
}

void update_stress(Blocks& blocks, BlockRange range, const Settings& settings,
                   double dt) {
  // Looked up once per run of equal materials: blocks of a layer stand together.
  int material = 0;
  double c11 = 0, c12 = 0, twice_g = 0;
  for (int b = range.first; b < range.last; ++b) {
    if (!blocks.is_free(b))
      continue;
    if (blocks.material[b] != material) {
      material = blocks.material[b];
      const Material& m = settings.materials.at(material);
      c11 = m.c11(), c12 = m.c12(), twice_g = 2.0 * m.shear_modulus;
    }
    const auto rate = blocks.strain_rate.col(b);
    auto stress = blocks.stress.col(b);
    stress[0] += dt * (c11 * rate[0] + c12 * rate[3]);
    stress[1] += dt * twice_g * rate[1];
    stress[2] = stress[1];
    stress[3] += dt * (c12 * rate[0] + c11 * rate[3]);
  }
}

namespace {

/// Whether all that is within `reach` of the point is inside the domain.
bool well_inside(const Vec2& point, double reach, const Settings& settings) {
  return point.x() - reach >= settings.lower.x() &&
         point.y() - reach >= settings.lower.y() &&
         point.x() + reach <= settings.upper.x() &&
         point.y() + reach <= settings.upper.y();
}

bool inside(const Blocks& blocks, int b, const Settings& settings) {
  const auto corners =
      blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  return (corners.rowwise().minCoeff().array() >= settings.lower.array()).all() &&
         (corners.rowwise().maxCoeff().array() <= settings.upper.array()).all();
}

/// What the sum of a rigid block's swing grows by: that by which turn and Cayley
/// rotation differ, and round-off.
double beside_angle(double turn, double angle, double longest) {
  return turn != 0.0 ? longest * (std::abs(turn * turn * turn) / 12.0 +
                                  0x1p-50 * (1.0 + std::abs(angle)))
                     : 0.0;
}

}  // namespace

Displacement move_blocks(Blocks& blocks, BlockRange range, Swing& swing,
                         const Settings& settings, double dt) {
  Displacement result;
  double sum = 0.0;  // carries a NaN that max would drop
  for (int b = range.first; b < range.last; ++b) {
    if (!blocks.is_free(b))
      continue;
    const Vec2 shift = dt * blocks.velocity.col(b);
    const Vec2 centroid = blocks.centroid.col(b) + shift;
    // not the shift: of half a unit in the last place it makes a whole one
    const double went = (centroid - blocks.centroid.col(b)).norm();
    const double turn = dt * blocks.spin[b];
    const Eigen::Matrix2d rotation = cayley_rotation(turn);
    Eigen::Matrix2d transform = rotation;
    if (!settings.rigid) {
      rotate_symmetric(blocks.stress.col(b), rotation);
      auto rate = blocks.strain_rate.col(b);
      transform = rotation * (Eigen::Matrix2d() << 1.0 + dt * rate[0], dt * rate[1],
                              dt * rate[2], 1.0 + dt * rate[3])
                                 .finished();
      rotate_symmetric(rate, rotation);
    }
    blocks.centroid.col(b) = centroid;
    blocks.angle[b] += turn;

    double swung = 0.0;
    if (settings.rigid) {
      const double beside = beside_angle(turn, blocks.angle[b], swing.longest[b]);
      swung = swing.longest[b] * std::abs(turn) + beside;
      swing.sum[b] += beside;
    }
    double farthest = 0.0, stretch = 1.0;
    for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c) {
      const Vec2 arm = transform * Vec2(blocks.arm.col(c));
      if (!settings.rigid)
        farthest = std::max(farthest, (arm - blocks.arm.col(c)).squaredNorm());
      blocks.arm.col(c) = arm;
      blocks.corner.col(c) = centroid + arm;
    }
    if (!settings.rigid) {
      swung = std::sqrt(farthest);
      Eigen::Map<Eigen::Matrix2d> shape(swing.shape.col(b).data());
      shape = (transform * shape).eval();
      stretch = shape.norm();
      swing.sum[b] += 0x1p-49 * swing.longest[b] * stretch;
    }
    const double moved = went + swung;
    const double way = 1.0000001 * (went + 2.0 * swung) + 0x1p-52 * swing.way[b];
    swing.way[b] += way;
    result.way = std::max(result.way, way + 0x1p-52 * swing.way[b]);
    sum += moved + transform.sum();  // NaN where a turn overflows, whose way does not
    if (moved > result.largest)
      result.largest = moved, result.block = b;
    if (!well_inside(centroid, swing.longest[b] * stretch + swing.sum[b], settings) &&
        !inside(blocks, b, settings))
      result.left_domain = true;
  }
  result.finite = std::isfinite(sum);
  return result;
}

}  // namespace blocks::dynamics
