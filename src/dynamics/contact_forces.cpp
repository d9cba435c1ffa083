#include "dynamics/contact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/applied_force.hpp"
#include "dynamics/contact_law.hpp"
#include "dynamics/contact_search.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// Velocity of the material point of block b at `arm` from its centroid; strain rates
/// included, zero for a rigid block (14).
inline Vec2 point_velocity(const Blocks& blocks, int b, const Vec2& arm) {
  const auto rate = blocks.strain_rate.col(b);
  const double spin = blocks.spin[b];
  return {blocks.velocity(0, b) + rate[0] * arm.x() + (rate[1] - spin) * arm.y(),
          blocks.velocity(1, b) + (rate[2] + spin) * arm.x() + rate[3] * arm.y()};
}

/// Rules 9, 10, 12 and (20) for one record.
inline bool admissible(const Blocks& blocks, int c, int edge, int edge_block) {
  const Vec2 corner = blocks.corner.col(c);
  const Vec2 p1 = blocks.corner.col(edge), p2 = blocks.corner.col(blocks.next[edge]);
  return geometry::in_reach_of_edge(corner, blocks.centroid.col(edge_block), p1, p2) &&
         geometry::faces_edge(corner, blocks.corner.col(blocks.previous[c]), p1, p2) &&
         geometry::faces_edge(corner, blocks.corner.col(blocks.next[c]), p1, p2);
}

/// Whether the corner is inside the block, not only behind the line of its nearest
/// edge: beside a slanted side that line's strip reaches out of the block
/// (docs/departures.md). Inside by more than nothing for the edge that acts, up to the
/// slack for the others.
bool penetrates(const Blocks& blocks, int c, int edge, int edge_block) {
  const Vec2 corner = blocks.corner.col(c);
  if (geometry::overlap_sign(corner, blocks.corner.col(edge),
                             blocks.corner.col(blocks.next[edge])) <= 0)
    return false;
  if (!blocks.convex[edge_block])
    return true;
  for (int e = blocks.next[edge]; e != edge; e = blocks.next[e])
    if (!geometry::near_or_inside(corner, blocks.corner.col(e),
                                  blocks.corner.col(blocks.next[e])))
      return false;
  return true;
}

/// Of the records first .. last - 1 (one corner, edges of one block) the one that acts,
/// or -1: the admissible edge with the least depth, if the corner is inside it (rule
/// 12).
int acting_record(const Blocks& blocks, const Contacts& contacts, int first, int last) {
  int best = -1;
  const int c = contacts.corner[first];
  for (int i = first; i < last; ++i) {
    if (!admissible(blocks, c, contacts.edge[i], contacts.edge_block[i]))
      continue;
    if (best < 0) {
      best = i;
      continue;
    }
    const int e = contacts.edge[i], f = contacts.edge[best];
    if (geometry::compare_depth(blocks.corner.col(c), blocks.corner.col(e),
                                blocks.corner.col(blocks.next[e]), blocks.corner.col(f),
                                blocks.corner.col(blocks.next[f])) < 0)
      best = i;
  }
  if (best < 0)
    return -1;
  return penetrates(blocks, c, contacts.edge[best], contacts.edge_block[best]) ? best
                                                                               : -1;
}

void release(Contacts& contacts, int i) {
  contacts.active[i] = 0;
  contacts.normal_elastic[i] = contacts.shear_elastic[i] = 0.0;
  contacts.normal_force[i] = contacts.shear_force[i] = 0.0;
  contacts.overlap[i] = 0.0;
}

/// Which record of the group acts, and for how long that is certain.
void decide(const Blocks& blocks, const Swing& swing, Contacts& contacts,
            ContactGroup& group) {
  group.acting = acting_record(blocks, contacts, group.first, group.last);
  for (int i = group.first; i < group.last; ++i)
    if (i != group.acting && contacts.active[i])
      release(contacts, i);
  group.certain = certain_travel(blocks, contacts, group);
  mark_position(blocks, swing, group);
}

inline void act(Blocks& blocks, Contacts& contacts, int i, const ContactLaw& law) {
  const int c = contacts.corner[i], e = contacts.edge[i];
  const int a = contacts.corner_block[i], b = contacts.edge_block[i];
  const Vec2 at = blocks.corner.col(c);
  const Vec2 p1 = blocks.corner.col(e), p2 = blocks.corner.col(blocks.next[e]);

  // a. Frame of the edge and relative velocity of the two material points.
  const Vec2 along = p2 - p1;
  const double length = along.norm();
  const Vec2 t = along / length;
  const Vec2 n(-t.y(), t.x());
  // its sign was decided exactly; rounded, a tiny depth may come out below zero
  const double overlap = std::max(0.0, geometry::cross(at - p1, along) / length);
  const Vec2 arm_a = blocks.arm.col(c);
  const Vec2 arm_b = at - blocks.centroid.col(b);
  const Vec2 v = point_velocity(blocks, a, arm_a) - point_velocity(blocks, b, arm_b);

  // b.-d.
  ElasticForce spring{contacts.normal_elastic[i], contacts.shear_elastic[i]};
  const ContactForce force = apply(law, spring, -v.dot(n), v.dot(t), overlap,
                                   contacts.damping[i], !contacts.active[i]);
  contacts.active[i] = 1;
  contacts.normal_elastic[i] = spring.normal;
  contacts.shear_elastic[i] = spring.shear;
  contacts.normal_force[i] = force.normal;
  contacts.shear_force[i] = force.shear;
  contacts.overlap[i] = overlap;

  // e. Equal and opposite at one point.
  const Vec2 f = force.normal * n - force.shear * t;
  add_force(blocks, a, arm_a, f);
  add_force(blocks, b, arm_b, -f);
}

}  // namespace

void add_contact_forces(Blocks& blocks, Contacts& contacts,
                        std::vector<ContactGroup>& groups, const Swing& swing,
                        const Settings& settings, double dt) {
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness,
                       settings.friction, dt};
  for (ContactGroup& group : groups) {
    // the other way round a NaN would let a decision stand
    if (!(relative_motion(blocks, swing, group) < group.certain))
      decide(blocks, swing, contacts, group);
    if (group.acting >= 0)
      act(blocks, contacts, group.acting, law);
  }
}

void add_plane_forces(Blocks& blocks, PlaneContacts& contacts, const Settings& settings,
                      double dt) {
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness, 0.0, dt};
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
    ElasticForce spring{contacts.normal_elastic[i], 0.0};
    const double damping = damping_against_fixed(settings, blocks.mass[b]);
    const ContactForce force =
        apply(law, spring, -point_velocity(blocks, b, arm).dot(n), 0.0, overlap,
              damping, !contacts.active[i]);
    contacts.active[i] = 1;
    contacts.normal_elastic[i] = spring.normal;
    contacts.normal_force[i] = force.normal;
    contacts.overlap[i] = overlap;
    add_force(blocks, b, arm, force.normal * n);
  }
}

}  // namespace blocks::dynamics
