#include "dynamics/contact_search.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/contact_decision.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// The edges of block b that could act on corner c.
void add_records(const Blocks& blocks, int b, int c, SearchBuffers& buffers) {
  const Vec2 corner = blocks.corner.col(c);
  const int other = blocks.corner_block[c], first = blocks.first_corner[b];
  const int count = static_cast<int>(buffers.reach.size());
  const auto add = [&](int e) {
    buffers.found.push_back({std::min(b, other), std::max(b, other), c, first + e});
  };
  int outside = 0, side = 0;
  const std::size_t before = buffers.found.size();
  for (int e = 0; e < count; ++e) {
    const Reach& reach = buffers.reach[e];
    const double overlap = reach.overlap(corner);
    if (overlap < -reach.near)
      ++outside, side = e;
    else if (overlap <= reach.depth + reach.near)
      add(e);
  }
  if (!blocks.convex[b] || outside == 0)
    return;
  // outside of one edge is outside of the block: there is but a crossing of sides
  std::size_t kept = before;
  if (outside == 1)
    for (std::size_t i = before; i < buffers.found.size(); ++i) {
      const int e = buffers.found[i].edge - first;
      const bool beside = (e + 1) % count == side || (side + 1) % count == e;
      if (beside && buffers.reach[e].between(corner))
        buffers.found[kept++] = buffers.found[i];
    }
  buffers.found.resize(kept);
}

void find_near_corners(const Model& model, SearchBuffers& buffers) {
  const Blocks& blocks = model.blocks;
  for (int b = 0; b < blocks.size(); ++b) {
    const double travel =
        2.0 * model.settings.contact_tolerance + shield_reach(blocks, b);
    const int first = blocks.first_corner[b], count = blocks.corners_of(b);
    buffers.reach.clear();
    for (int e = first; e < first + count; ++e)
      buffers.reach.emplace_back(blocks, b, e, travel);
    const auto corners = blocks.corner.middleCols(first, count);
    Vec2 lower = corners.rowwise().minCoeff(), upper = corners.rowwise().maxCoeff();
    // no edge is longer than the two extents together
    const double near = travel + geometry::contact_slack * (upper - lower).sum();
    for (const Reach& reach : buffers.reach)
      reach.extend(lower, upper);
    lower.array() -= near, upper.array() += near;
    buffers.grid.visit(lower, upper, [&](int c) {
      const int other = blocks.corner_block[c];
      if (other == b || (!blocks.is_free(b) && !blocks.is_free(other)))
        return;
      add_records(blocks, b, c, buffers);
    });
  }
}

SearchBuffers::Record record(const Contacts& contacts, int i) {
  const int a = contacts.corner_block[i], b = contacts.edge_block[i];
  return {std::min(a, b), std::max(a, b), contacts.corner[i], contacts.edge[i]};
}

/// Writes the records found into `next`, with the state of those that were there
/// before.
void merge(const Blocks& blocks, const Contacts& old, SearchBuffers& buffers) {
  Contacts& next = buffers.next;
  next.resize(static_cast<int>(buffers.found.size()));
  int j = 0;
  for (int i = 0; i < next.size(); ++i) {
    const SearchBuffers::Record& r = buffers.found[i];
    next.corner[i] = r.corner;
    next.edge[i] = r.edge;
    next.corner_block[i] = blocks.corner_block[r.corner];
    next.edge_block[i] = blocks.corner_block[r.edge];
    next.active[i] = 0;
    while (j < old.size() && record(old, j) < r)
      ++j;
    if (j < old.size() && record(old, j) == r) {
      next.active[i] = old.active[j];
      next.normal_elastic[i] = old.normal_elastic[j];
      next.shear_elastic[i] = old.shear_elastic[j];
      next.normal_force[i] = old.normal_force[j];
      next.shear_force[i] = old.shear_force[j];
      next.overlap[i] = old.overlap[j];
    }
  }
}

void update_plane_contacts(Model& model, SearchBuffers& buffers) {
  const Blocks& blocks = model.blocks;
  const PlaneContacts& old = model.plane_contacts;
  const double reach = 2.0 * model.settings.contact_tolerance;
  std::vector<std::pair<int, int>> found;
  for (int k = 0; k < static_cast<int>(model.settings.planes.size()); ++k) {
    const Plane& plane = model.settings.planes[k];
    const Vec2 t = (plane.b - plane.a).normalized();
    for (int c = 0; c < blocks.corners(); ++c)
      if (blocks.is_free(blocks.corner_block[c]) &&
          geometry::cross(t, blocks.corner.col(c) - plane.a) <= reach)
        found.emplace_back(k, c);
  }
  PlaneContacts& next = buffers.next_planes;
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

}  // namespace

double damping_against_fixed(const Settings& settings, double mass) {
  return settings.damping * 2.0 * std::sqrt(settings.normal_stiffness * mass);
}

void set_contact_damping(Model& model) {
  const Blocks& blocks = model.blocks;
  Contacts& contacts = model.contacts;
  for (int i = 0; i < contacts.size(); ++i) {
    const int a = contacts.corner_block[i], b = contacts.edge_block[i];
    const double ma = blocks.mass[a], mb = blocks.mass[b];
    const double mass = !blocks.is_free(a)   ? mb
                        : !blocks.is_free(b) ? ma
                                             : ma * mb / (ma + mb);
    contacts.damping[i] = damping_against_fixed(model.settings, mass);
  }
}

void update_contacts(Model& model, SearchBuffers& buffers) {
  buffers.found.clear();
  buffers.grid.fill(model);
  find_near_corners(model, buffers);
  adopt_list(model, buffers);
}

void adopt_list(Model& model, SearchBuffers& buffers) {
  std::sort(buffers.found.begin(), buffers.found.end());
  merge(model.blocks, model.contacts, buffers);
  std::swap(model.contacts, buffers.next);
  update_plane_contacts(model, buffers);
  set_contact_damping(model);
  model.search.current = true;
  model.search.travel = 0.0;
  ++model.search.updates;
}

}  // namespace blocks::dynamics
