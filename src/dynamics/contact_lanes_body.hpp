// The computations of contact_lanes.hpp. Included once for each instruction set, in a
// namespace of its own; calls nothing that is not compiled here.
#include "dynamics/contact_lanes.hpp"

#include <cmath>

namespace blocks::dynamics::BLOCKS_LANES {

void overlaps(OverlapLanes& l) {
  for (int k = 0; k < lane_count; ++k) {
    const double ex = l.x2[k] - l.x1[k], ey = l.y2[k] - l.y1[k];
    const double plus = (l.xc[k] - l.x1[k]) * ey, minus = (l.yc[k] - l.y1[k]) * ex;
    const double length = __builtin_sqrt(ex * ex + ey * ey);
    const double value = plus - minus, overlap = value / length;
    l.value[k] = value;
    // filter::overlap of geometry/contact_predicates.hpp
    l.bound[k] = 0x1p-51 * (__builtin_fabs(plus) + __builtin_fabs(minus)) + 0x1p-1000;
    l.tangent_x[k] = ex / length;
    l.tangent_y[k] = ey / length;
    // its sign is decided exactly; rounded, a tiny depth may come out below zero
    l.overlap[k] = overlap > 0.0 ? overlap : 0.0;
  }
}

template <bool rigid> void forces_of(ForceLanes& l, const ContactLaw& law) {
  for (int k = 0; k < lane_count; ++k) {
    // a. relative velocity of the two material points (14)
    const double ax = l.arm_ax[k], ay = l.arm_ay[k];
    const double bx = l.arm_bx[k], by = l.arm_by[k];
    double vax = l.vax[k] - l.spin_a[k] * ay, vay = l.vay[k] + l.spin_a[k] * ax;
    double vbx = l.vbx[k] - l.spin_b[k] * by, vby = l.vby[k] + l.spin_b[k] * bx;
    if (!rigid) {
      vax += l.rate_a[0][k] * ax + l.rate_a[1][k] * ay;
      vay += l.rate_a[2][k] * ax + l.rate_a[3][k] * ay;
      vbx += l.rate_b[0][k] * bx + l.rate_b[1][k] * by;
      vby += l.rate_b[2][k] * bx + l.rate_b[3][k] * by;
    }
    const double vx = vax - vbx, vy = vay - vby;
    const double tx = l.tangent_x[k], ty = l.tangent_y[k], nx = -ty, ny = tx;

    // b.-d.
    double normal_elastic = l.normal_elastic[k], shear_elastic = l.shear_elastic[k];
    double normal, shear;
    apply(law, normal_elastic, shear_elastic, -(vx * nx + vy * ny), vx * tx + vy * ty,
          l.overlap[k], l.damping[k], l.starting[k], normal, shear);
    l.normal_elastic[k] = normal_elastic;
    l.shear_elastic[k] = shear_elastic;
    l.normal_force[k] = normal;
    l.shear_force[k] = shear;

    // e. equal and opposite at one point
    const double fx = normal * nx - shear * tx, fy = normal * ny - shear * ty;
    l.fx[k] = fx;
    l.fy[k] = fy;
    l.moment_a[k] = ax * fy - ay * fx;
    l.moment_b[k] = by * fx - bx * fy;
    l.sums_a[0][k] = fx * ax;
    l.sums_a[1][k] = fx * ay;
    l.sums_a[2][k] = fy * ax;
    l.sums_a[3][k] = fy * ay;
    l.sums_b[0][k] = -fx * bx;
    l.sums_b[1][k] = -fx * by;
    l.sums_b[2][k] = -fy * bx;
    l.sums_b[3][k] = -fy * by;
  }
}

void forces(ForceLanes& lanes, const ContactLaw& law, bool rigid) {
  rigid ? forces_of<true>(lanes, law) : forces_of<false>(lanes, law);
}

}  // namespace blocks::dynamics::BLOCKS_LANES
