#include "dynamics/symmetry_planes.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "dynamics/applied_force.hpp"
#include "dynamics/contacts/dashpot.hpp"
#include "dynamics/kernels/contact_law.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// Returns the velocity (14) of the material point of block b at `arm` from its
/// centroid. The strain rates are included; they are zero for a rigid block.
Vec2 point_velocity(const Blocks& blocks, int b, const Vec2& arm) {
  const auto rate = blocks.strain_rate.col(b);
  const double spin = blocks.spin[b];
  return {blocks.velocity(0, b) + rate[0] * arm.x() + (rate[1] - spin) * arm.y(),
          blocks.velocity(1, b) + (rate[2] + spin) * arm.x() + rate[3] * arm.y()};
}

}  // namespace

void update_plane_contacts(Model& model, PlaneContacts& memory, double tolerance) {
  const Blocks& blocks = model.blocks;
  const PlaneContacts& old = model.plane_contacts;
  const double reach = 2.0 * tolerance;
  std::vector<std::pair<int, int>> found;
  for (int k = 0; k < static_cast<int>(model.settings.planes.size()); ++k) {
    const Plane& plane = model.settings.planes[k];
    const Vec2 t = (plane.b - plane.a).normalized();
    for (int c = 0; c < blocks.corners(); ++c)
      if (blocks.is_free(blocks.corner_block[c]) &&
          geometry::cross(t, blocks.corner.col(c) - plane.a) <= reach)
        found.emplace_back(k, c);
  }
  PlaneContacts& next = memory;
  next.resize(static_cast<int>(found.size()));
  int j = 0;
  for (int i = 0; i < next.size(); ++i) {
    next.plane[i] = found[i].first;
    next.corner[i] = found[i].second;
    next.active[i] = 0;
    while (j < old.size() && std::pair(old.plane[j], old.corner[j]) < found[i])
      ++j;
    if (j < old.size() && std::pair(old.plane[j], old.corner[j]) == found[i]) {
      next.active[i] = old.active[j];
      next.normal_elastic[i] = old.normal_elastic[j];
      next.normal_force[i] = old.normal_force[j];
      next.overlap[i] = old.overlap[j];
    }
  }
  std::swap(model.plane_contacts, next);
}

Extremes add_plane_forces(Blocks& blocks, PlaneContacts& contacts,
                          const Settings& settings, double dt) {
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness, 0.0, dt};
  Extremes extremes;
  for (int i = 0; i < contacts.size(); ++i) {
    const Plane& plane = settings.planes[contacts.plane[i]];
    const int c = contacts.corner[i], b = blocks.corner_block[c];
    const Vec2 at = blocks.corner.col(c);
    if (!blocks.is_free(b) || geometry::overlap_sign(at, plane.a, plane.b) <= 0) {
      contacts.active[i] = 0;
      contacts.normal_elastic[i] = contacts.normal_force[i] = contacts.overlap[i] = 0.0;
      continue;
    }
    const Vec2 along = plane.b - plane.a;
    const double length = along.norm();
    const Vec2 n(-along.y() / length, along.x() / length);
    const double overlap = std::max(0.0, geometry::cross(at - plane.a, along) / length);
    const Vec2 arm = blocks.present_arm(c);
    const double damping = damping_against_fixed(settings, blocks.mass[b]);
    double shear_elastic = 0.0, normal = 0.0, shear = 0.0;
    apply(law, contacts.normal_elastic[i], shear_elastic,
          -point_velocity(blocks, b, arm).dot(n), 0.0, overlap, damping,
          contacts.active[i] ? 0.0 : 1.0, normal, shear);
    contacts.active[i] = 1;
    contacts.normal_force[i] = normal;
    contacts.overlap[i] = overlap;
    add_force(blocks, b, arm, normal * n);
    extremes.include({overlap, contacts.normal_elastic[i]});
  }
  return extremes;
}

}  // namespace blocks::dynamics
