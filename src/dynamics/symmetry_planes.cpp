#include "dynamics/symmetry_planes.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "dynamics/applied_force.hpp"
#include "dynamics/contacts/dashpot.hpp"
#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/point_velocity.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {

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

PlaneForce plane_force(const Blocks& blocks, const PlaneContacts& contacts, int i,
                       const Settings& settings, double dt) {
  PlaneForce force;
  const Plane& plane = settings.planes[contacts.plane[i]];
  const int c = contacts.corner[i], b = blocks.corner_block[c];
  const Vec2 at = blocks.corner.col(c);
  if (!blocks.is_free(b) || geometry::overlap_sign(at, plane.a, plane.b) <= 0)
    return force;
  force.acts = true;
  const Vec2 along = plane.b - plane.a;
  const double length = along.norm();
  force.inward = {-along.y() / length, along.x() / length};
  force.overlap = std::max(0.0, geometry::cross(at - plane.a, along) / length);
  force.arm = blocks.present_arm(c);
  force.closing = -point_velocity(blocks, b, force.arm).dot(force.inward);
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness, 0.0, dt};
  const double damping = damping_against_fixed(settings, blocks.inertial_mass(b));
  double shear_elastic = 0.0, shear = 0.0;
  force.spring = contacts.normal_elastic[i];
  apply(law, force.spring, shear_elastic, force.closing, 0.0, force.overlap, damping,
        contacts.active[i] ? 0.0 : 1.0, force.normal, shear);
  return force;
}

Extremes add_plane_forces(Blocks& blocks, PlaneContacts& contacts,
                          const Settings& settings, double dt) {
  Extremes extremes;
  for (int i = 0; i < contacts.size(); ++i) {
    const PlaneForce force = plane_force(blocks, contacts, i, settings, dt);
    contacts.active[i] = force.acts ? 1 : 0;
    contacts.normal_elastic[i] = force.spring;
    contacts.normal_force[i] = force.normal;
    contacts.overlap[i] = force.overlap;
    if (!force.acts)
      continue;
    add_force(blocks, blocks.corner_block[contacts.corner[i]], force.arm,
              force.normal * force.inward);
    extremes.include({force.overlap, force.spring});
  }
  return extremes;
}

}  // namespace blocks::dynamics
