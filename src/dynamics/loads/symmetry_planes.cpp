#include "dynamics/loads/symmetry_planes.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "dynamics/contacts/dashpot.hpp"
#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/loads/applied_force.hpp"
#include "dynamics/loads/point_velocity.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {

void update_plane_contacts(Model& model, std::vector<PlaneContact>& memory,
                           double tolerance) {
  const Blocks& blocks = model.blocks;
  // A corner farther away than `tolerance` cannot touch the plane; the rest is a
  // margin.
  const double reach = 2.0 * tolerance;
  std::vector<PlaneContact>& next = memory;
  next.clear();
  auto old = model.plane_contacts.begin();
  for (int k = 0; k < static_cast<int>(model.settings.planes.size()); ++k) {
    const Plane& plane = model.settings.planes[k];
    const Vec2 along = (plane.b - plane.a).normalized();
    for (int c = 0; c < blocks.corners(); ++c) {
      while (old != model.plane_contacts.end() &&
             std::pair(old->plane, old->corner) < std::pair(k, c))
        ++old;
      const bool listed =
          old != model.plane_contacts.end() && old->plane == k && old->corner == c;
      if (!blocks.is_free(blocks.corner_block[c]))
        continue;
      const double gap = geometry::cross(along, blocks.corner.col(c) - plane.a);
      if (gap <= reach || (listed && gap <= reach + old->offset))
        next.push_back(listed ? *old : PlaneContact{.plane = k, .corner = c});
    }
  }
  std::swap(model.plane_contacts, next);
}

PlaneForce plane_force(const Blocks& blocks, const PlaneContact& contact,
                       const Settings& settings, double dt) {
  PlaneForce force;
  const Plane& plane = settings.planes[contact.plane];
  const int c = contact.corner, b = blocks.corner_block[c];
  if (!blocks.is_free(b))
    return force;
  const Vec2 at = blocks.corner.col(c), along = plane.b - plane.a;
  const double length = along.norm();
  const double depth = geometry::cross(at - plane.a, along) / length;
  force.acts = geometry::overlap_sign(at, plane.a, plane.b) > 0 ||
               (contact.offset > 0.0 && depth + contact.offset > 0.0);
  if (!force.acts)
    return force;
  force.inward = {-along.y() / length, along.x() / length};
  force.overlap = std::max(0.0, depth);
  // On the plane, half way between the corner and its mirror image: in the model
  // without the plane, the contacts of both act on the block.
  force.arm = blocks.present_arm(c) + depth * force.inward;
  // Velocities are those of half a step before the positions
  // (docs/theory.md#the-velocities-of-a-contact).
  const Vec2 inwards = 0.5 * dt * (blocks.spin[b] * blocks.spin[b]) * force.arm;
  force.lag = inwards.dot(force.inward);
  force.closing = -point_velocity(blocks, b, force.arm).dot(force.inward) - force.lag;
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness, 0.0, dt};
  const double damping = damping_against_fixed(settings, blocks.inertial_mass(b));
  ContactState<double> state = usual_state(law, contact.normal_elastic, 0.0);
  ContactForce<double> forces;
  const double starts = contact.active ? 0.0 : 1.0;
  apply_usual(law, {force.closing, 0.0, force.overlap, damping, starts}, state, forces);
  force.spring = state.normal, force.normal = forces.normal;
  return force;
}

Extremes add_plane_forces(Model& model) {
  Extremes extremes;
  for (PlaneContact& contact : model.plane_contacts) {
    const PlaneForce force =
        plane_force(model.blocks, contact, model.settings, model.time_step.dt);
    contact.active = force.acts;
    contact.normal_elastic = force.spring;
    contact.normal_force = force.normal;
    contact.overlap = force.overlap;
    if (!force.acts) {
      contact.offset = 0.0;
      continue;
    }
    add_force(model.blocks, model.blocks.corner_block[contact.corner], force.arm,
              force.normal * force.inward);
    extremes.include({force.overlap, force.spring});
  }
  return extremes;
}

}  // namespace blocks::dynamics
