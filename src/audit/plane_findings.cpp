#include "audit/plane_findings.hpp"

#include <map>
#include <utility>

#include "audit/whole_numbers.hpp"

namespace blocks::audit {
namespace {

/// Returns whether a point is on the right of a plane, exactly.
bool is_behind(const Vec2& at, const Plane& plane) {
  Lattice lattice;
  for (const Vec2& p : {at, plane.a, plane.b})
    lattice.include(p.x()), lattice.include(p.y());
  const Point from = lattice(plane.a);
  return sign(cross(lattice(plane.b) - from, lattice(at) - from)) < 0;
}

}  // namespace

std::vector<PlaneFault> plane_faults(const Moment& moment) {
  const Blocks& blocks = moment.blocks;
  std::map<std::pair<int, int>, const PlaneContact*> acting;
  for (const PlaneContact& contact : moment.plane_contacts)
    if (contact.active)
      acting[{contact.plane, contact.corner}] = &contact;
  std::vector<PlaneFault> faults;
  for (int k = 0; k < static_cast<int>(moment.settings.planes.size()); ++k)
    for (int c = 0; c < blocks.corners(); ++c) {
      if (!blocks.is_free(blocks.corner_block[c]))
        continue;
      const auto found = acting.find({k, c});
      const bool acts = found != acting.end();
      const bool held = acts && found->second->offset > 0.0;
      const bool behind = is_behind(blocks.corner.col(c), moment.settings.planes[k]);
      if (behind ? !acts : acts && !held)
        faults.push_back({k, c, acts});
    }
  return faults;
}

BehindPlane deepest_behind_plane(const Moment& moment) {
  const Blocks& blocks = moment.blocks;
  BehindPlane deepest;
  for (int k = 0; k < static_cast<int>(moment.settings.planes.size()); ++k) {
    const Plane& plane = moment.settings.planes[k];
    const Vec2 along = (plane.b - plane.a).normalized();
    for (int c = 0; c < blocks.corners(); ++c) {
      const double depth = geometry::cross(Vec2(blocks.corner.col(c)) - plane.a, along);
      if (blocks.is_free(blocks.corner_block[c]) && depth > deepest.depth)
        deepest = {k, c, depth, 0.0};
    }
  }
  for (const PlaneContact& contact : moment.plane_contacts)
    if (contact.plane == deepest.plane && contact.corner == deepest.corner)
      deepest.pressed = contact.normal_elastic / moment.settings.normal_stiffness;
  return deepest;
}

}  // namespace blocks::audit
