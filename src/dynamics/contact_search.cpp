#include "dynamics/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

/// Orders the records: by the lower block in one go, then those of each.
void sort_found(int blocks, SearchBuffers& buffers) {
  std::vector<int> first(blocks + 1, 0);
  for (const SearchBuffers::Record& r : buffers.found)
    ++first[r.low + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<SearchBuffers::Record> sorted(buffers.found.size());
  for (const SearchBuffers::Record& r : buffers.found)
    sorted[first[r.low]++] = r;
  auto begin = sorted.begin();
  for (int b = 0; b < blocks; ++b) {  // each first was moved on to its end
    const auto end = sorted.begin() + first[b];
    std::sort(begin, end);
    begin = end;
  }
  buffers.found.swap(sorted);
}

/// What acts, out of a list that is not needed any more.
void keep_acting(Contacts& contacts, std::vector<SearchBuffers::Kept>& kept) {
  kept.clear();
  for (int i = 0; i < contacts.size(); ++i)
    if (contacts.active[i])
      kept.push_back({record(contacts, i), contacts.normal_elastic[i],
                      contacts.shear_elastic[i], contacts.normal_force[i],
                      contacts.shear_force[i], contacts.overlap[i]});
  contacts.resize(0);
}

/// Makes the records found the list, with the state of those that act: the others have
/// none.
void fill_list(const Blocks& blocks, Contacts& contacts, const SearchBuffers& buffers) {
  contacts.resize(static_cast<int>(buffers.found.size()));
  auto kept = buffers.kept.begin();
  for (int i = 0; i < contacts.size(); ++i) {
    const SearchBuffers::Record& r = buffers.found[i];
    contacts.corner[i] = r.corner;
    contacts.edge[i] = r.edge;
    contacts.corner_block[i] = blocks.corner_block[r.corner];
    contacts.edge_block[i] = blocks.corner_block[r.edge];
    while (kept != buffers.kept.end() && kept->record < r)
      ++kept;
    const bool acts = kept != buffers.kept.end() && kept->record == r;
    contacts.active[i] = acts;
    if (!acts)
      continue;
    contacts.normal_elastic[i] = kept->normal_elastic;
    contacts.shear_elastic[i] = kept->shear_elastic;
    contacts.normal_force[i] = kept->normal_force;
    contacts.shear_force[i] = kept->shear_force;
    contacts.overlap[i] = kept->overlap;
  }
}

/// Memory that only a search needs: some stays, for to ask for it at every search of a
/// small model is slower.
template <class Item> void give_back(std::vector<Item>& items) {
  items.clear();
  if (items.capacity() * sizeof(Item) > 1 << 25)
    items.shrink_to_fit();
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
  keep_acting(model.contacts, buffers.kept);
  sort_found(model.blocks.size(), buffers);
  fill_list(model.blocks, model.contacts, buffers);
  give_back(buffers.found);
  give_back(buffers.kept);
  update_plane_contacts(model, buffers);
  set_contact_damping(model);
  model.search.current = true;
  model.search.travel = 0.0;
  ++model.search.updates;
}

}  // namespace blocks::dynamics
