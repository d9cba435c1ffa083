#include "dynamics/contact_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "dynamics/contact_decision.hpp"
#include "dynamics/give_back.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// The edges of block b that could act on corner c.
void add_records(const Blocks& blocks, int b, int c, SearchBuffers& buffers) {
  const Vec2 corner = blocks.corner.col(c);
  const int first = blocks.first_corner[b];
  const int count = static_cast<int>(buffers.reach.size());
  const auto add = [&](int e) { buffers.found.push_back({c, first + e}); };
  int outside = 0, side = 0;
  const std::size_t before = buffers.found.size();
  for (int e = 0; e < count; ++e) {
    const Reach& reach = buffers.reach[e];
    const double overlap = reach.overlap(corner);
    if (overlap < -reach.near) {
      side = e;
      if (++outside > 1 && blocks.convex[b])
        break;
    } else if (overlap <= reach.depth + reach.near) {
      add(e);
    }
  }
  if (!blocks.convex[b] || outside == 0)
    return;
  // outside of one edge is outside of the block: there is but a crossing of sides
  std::size_t kept = before;
  if (outside == 1) {
    const int after = side + 1 < count ? side + 1 : 0;
    const int ahead = side > 0 ? side - 1 : count - 1;
    for (std::size_t i = before; i < buffers.found.size(); ++i) {
      const int e = buffers.found[i].edge - first;
      if ((e == after || e == ahead) && buffers.reach[e].between(corner))
        buffers.found[kept++] = buffers.found[i];
    }
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
      const auto at = blocks.corner.col(c).array();
      const bool far = (at < lower.array()).any() || (at > upper.array()).any();
      const int other = blocks.corner_block[c];
      if (far || other == b || (!blocks.is_free(b) && !blocks.is_free(other)))
        return;
      add_records(blocks, b, c, buffers);
    });
  }
}

/// The order of lists: pair of blocks, lower number first, corner, edge; two to a word.
using Place = std::array<std::uint64_t, 2>;
Place place(const Blocks& blocks, int corner, int edge) {
  const auto word = [](int first, int second) {
    return std::uint64_t{static_cast<std::uint32_t>(first)} << 32 |
           static_cast<std::uint32_t>(second);
  };
  const int a = blocks.corner_block[corner], b = blocks.corner_block[edge];
  return {word(std::min(a, b), std::max(a, b)), word(corner, edge)};
}

/// Empties the list, all but the state of what acts, whose places are kept.
void empty_list(Contacts& contacts, std::vector<SearchBuffers::Record>& acted) {
  acted.clear();
  for (const ActingContact& contact : contacts.acting)
    acted.push_back({contacts.corner[contact.record], contacts.edge[contact.record]});
  contacts.corner.clear();
  contacts.edge.clear();
}

/// Makes the records found the list, in its order: by the lower block in one go, then
/// those of each. None acts.
void order_list(const Blocks& blocks, Contacts& contacts, SearchBuffers& buffers) {
  const auto low = [&](const SearchBuffers::Record& r) {
    return std::min(blocks.corner_block[r.corner], blocks.corner_block[r.edge]);
  };
  std::vector<int> last(blocks.size() + 1, 0);
  for (const SearchBuffers::Record& r : buffers.found)
    ++last[low(r) + 1];
  std::partial_sum(last.begin(), last.end(), last.begin());
  contacts.corner.resize(buffers.found.size());
  contacts.edge.resize(buffers.found.size());
  for (const SearchBuffers::Record& r : buffers.found) {
    const int i = last[low(r)]++;
    contacts.corner[i] = r.corner, contacts.edge[i] = r.edge;
  }
  give_back(buffers.found);
  contacts.active.assign(contacts.corner.size(), 0);
  std::vector<Place> places;
  for (int b = 0, i = 0; b < blocks.size(); ++b) {
    places.clear();
    for (int k = i; k < last[b]; ++k)
      places.push_back(place(blocks, contacts.corner[k], contacts.edge[k]));
    std::sort(places.begin(), places.end());
    for (const Place& each : places) {
      contacts.corner[i] = static_cast<int>(each[1] >> 32);
      contacts.edge[i] = static_cast<int>(each[1] & 0xffffffff);
      ++i;
    }
  }
}

/// The state of those that acted in the list before, where they stand, moved up over
/// that of records that are listed no more; the others have none.
void take_over(const Blocks& blocks, Contacts& contacts,
               const std::vector<SearchBuffers::Record>& acted) {
  std::vector<ActingContact>& acting = contacts.acting;
  std::size_t kept = 0;
  int i = 0;
  for (std::size_t k = 0; k < acted.size(); ++k) {
    const auto [corner, edge] = acted[k];
    const Place wanted = place(blocks, corner, edge);
    while (i < contacts.size() &&
           place(blocks, contacts.corner[i], contacts.edge[i]) < wanted)
      ++i;
    if (i == contacts.size() || contacts.corner[i] != corner ||
        contacts.edge[i] != edge)
      continue;
    contacts.active[i] = 1;
    acting[kept] = acting[k];
    acting[kept++].record = i;
  }
  acting.resize(kept);
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

void update_contacts(Model& model, SearchBuffers& buffers) {
  buffers.found.clear();
  buffers.grid.fill(model);
  find_near_corners(model, buffers);
  buffers.grid.give_back();
  adopt_list(model, buffers);
}

void adopt_list(Model& model, SearchBuffers& buffers) {
  empty_list(model.contacts, buffers.acted);
  order_list(model.blocks, model.contacts, buffers);
  take_over(model.blocks, model.contacts, buffers.acted);
  give_back(buffers.acted);
  update_plane_contacts(model, buffers);
  model.search.current = true;
  model.search.travel = 0.0;
  ++model.search.updates;
}

}  // namespace blocks::dynamics
