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
  if (group.hopeless > 0) {
    --group.hopeless;
    return;
  }
  group.certain = certain_travel(blocks, contacts, group);
  mark_position(blocks, swing, group);
  if (group.certain == 0.0)
    group.hopeless = 16;
}

/// a. Frame of the acting edge and overlap.
inline void measure(const Blocks& blocks, const Contacts& contacts,
                    ContactGroup& group) {
  const int c = contacts.corner[group.acting], e = contacts.edge[group.acting];
  const int e2 = blocks.next[e];
  const double x1 = blocks.corner(0, e), y1 = blocks.corner(1, e);
  const double ex = blocks.corner(0, e2) - x1, ey = blocks.corner(1, e2) - y1;
  const double wx = blocks.corner(0, c) - x1, wy = blocks.corner(1, c) - y1;
  const double length = std::sqrt(ex * ex + ey * ey);
  group.tangent_x = ex / length;
  group.tangent_y = ey / length;
  // its sign was decided exactly; rounded, a tiny depth may come out below zero
  group.overlap = std::max(0.0, (wx * ey - wy * ex) / length);
}

inline void act(Blocks& blocks, Contacts& contacts, const ContactGroup& group,
                const ContactLaw& law) {
  const int i = group.acting, c = contacts.corner[i];
  const int a = group.corner_block, b = group.edge_block;
  const double tx = group.tangent_x, ty = group.tangent_y;
  const double nx = -ty, ny = tx, overlap = group.overlap;
  const double x = blocks.corner(0, c), y = blocks.corner(1, c);

  // Relative velocity of the two material points. In plain numbers: vectors would go
  // through memory here.
  const Vec2 arm_a(blocks.arm(0, c), blocks.arm(1, c));
  const Vec2 arm_b(x - blocks.centroid(0, b), y - blocks.centroid(1, b));
  const Vec2 va = point_velocity(blocks, a, arm_a),
             vb = point_velocity(blocks, b, arm_b);
  const double vx = va.x() - vb.x(), vy = va.y() - vb.y();

  // b.-d.
  ElasticForce spring{contacts.normal_elastic[i], contacts.shear_elastic[i]};
  const ContactForce force = apply(law, spring, -(vx * nx + vy * ny), vx * tx + vy * ty,
                                   overlap, contacts.damping[i], !contacts.active[i]);
  contacts.active[i] = 1;
  contacts.normal_elastic[i] = spring.normal;
  contacts.shear_elastic[i] = spring.shear;
  contacts.normal_force[i] = force.normal;
  contacts.shear_force[i] = force.shear;
  contacts.overlap[i] = overlap;

  // e. Equal and opposite at one point.
  const double fx = force.normal * nx - force.shear * tx;
  const double fy = force.normal * ny - force.shear * ty;
  add_force(blocks, a, arm_a, {fx, fy});
  add_force(blocks, b, arm_b, {-fx, -fy});
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
      measure(blocks, contacts, group);
  }
  // apart from the forces, whose branches would wait for each root and quotient
  for (const ContactGroup& group : groups)
    if (group.acting >= 0)
      act(blocks, contacts, group, law);
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
