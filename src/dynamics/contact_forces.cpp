#include "dynamics/contact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/applied_force.hpp"
#include "dynamics/contact_loop.hpp"
#include "dynamics/dashpot.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {

Extremes evaluate_contacts(const Blocks& blocks, Contacts& contacts,
                           ContactGroups& groups, const Settings& settings, double dt,
                           Workers& workers, Profile* profile) {
  return evaluate_contacts_by<ExactRules>(blocks, contacts, groups, settings, dt,
                                          workers, profile);
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
    const Vec2 arm = blocks.arm.col(c);
    const double damping = damping_against_fixed(settings, blocks.mass[b]);
    double shear_elastic = 0.0, normal = 0.0, shear = 0.0;
    apply(law, contacts.normal_elastic[i], shear_elastic,
          -detail::point_velocity(blocks, b, arm).dot(n), 0.0, overlap, damping,
          contacts.active[i] ? 0.0 : 1.0, normal, shear);
    contacts.active[i] = 1;
    contacts.normal_force[i] = normal;
    contacts.overlap[i] = overlap;
    add_force(blocks, b, arm, normal * n);
    extremes.include(overlap, contacts.normal_elastic[i]);
  }
  return extremes;
}

}  // namespace blocks::dynamics
