#include "dynamics/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

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

/// Empties the list, all but the state of what acts, whose places are kept.
void empty_list(Contacts& contacts, std::vector<SearchBuffers::Record>& acted,
                EarlierGroups& earlier) {
  acted.clear();
  for (const ActingContact& contact : contacts.acting)
    acted.push_back({contacts.corner[contact.record], contacts.edge[contact.record]});
  if (!earlier.empty())
    earlier.take(contacts);
  contacts.corner.clear();
  contacts.edge.clear();
}

/// Calls visit(first, last) for each run of records found.
template <class Visit>
void each_run(const Blocks& blocks, const std::vector<SearchBuffers::Record>& found,
              const Visit& visit) {
  const int size = static_cast<int>(found.size());
  for (int first = 0, last; first < size; first = last) {
    const int end = blocks.first_corner[blocks.corner_block[found[first].edge] + 1];
    last = first + 1;
    while (last < size && found[last].corner == found[first].corner &&
           found[last].edge > found[last - 1].edge && found[last].edge < end)
      ++last;
    visit(first, last);
  }
}

/// Makes the records found the list, which is empty, in its order: runs by the lower
/// block in one go, then those of each block by the higher one and the corner. None
/// acts.
void order_list(const Blocks& blocks, Contacts& contacts, SearchBuffers& buffers) {
  using Run = SearchBuffers::Run;
  const std::vector<SearchBuffers::Record>& found = buffers.found;
  const auto blocks_of = [&](int i) {
    return std::minmax(blocks.corner_block[found[i].corner],
                       blocks.corner_block[found[i].edge]);
  };
  std::vector<int>& last = buffers.last_of_low;
  last.assign(blocks.size() + 1, 0);
  each_run(blocks, found, [&](int i, int) { ++last[blocks_of(i).first + 1]; });
  std::partial_sum(last.begin(), last.end(), last.begin());
  std::vector<Run>& runs = buffers.runs;
  runs.resize(last.back());
  each_run(blocks, found, [&](int first, int behind) {
    const auto [low, high] = blocks_of(first);
    const auto word = [](int number) { return static_cast<std::uint32_t>(number); };
    runs[last[low]++] = {std::uint64_t{word(high)} << 32 | word(found[first].corner),
                         first, behind};
  });
  contacts.corner.reserve(found.size());
  contacts.edge.reserve(found.size());
  for (int b = 0, first = 0; b < blocks.size(); ++b) {
    const int behind = last[b];
    std::sort(runs.begin() + first, runs.begin() + behind,
              [](const Run& l, const Run& r) { return l.place < r.place; });
    for (int k = std::exchange(first, behind); k < behind;) {
      const auto begin = std::ssize(contacts.edge);
      const int run = k;
      for (; k < behind && runs[k].place == runs[run].place; ++k)
        for (int i = runs[k].first; i < runs[k].last; ++i) {
          contacts.corner.push_back(found[i].corner);
          contacts.edge.push_back(found[i].edge);
        }
      if (k > run + 1)  // found in several pieces
        std::sort(contacts.edge.begin() + begin, contacts.edge.end());
    }
    last[b] = static_cast<int>(contacts.corner.size());
  }
  give_back(buffers.found);
  give_back(buffers.runs);
  contacts.active.assign(contacts.corner.size(), 0);
}

/// The state of those that acted in the list before, where they stand, moved up over
/// that of records that are listed no more; the others have none. Both lists have one
/// order.
void take_over(const Blocks& blocks, Contacts& contacts, const SearchBuffers& buffers) {
  std::vector<ActingContact>& acting = contacts.acting;
  using Place = std::tuple<int, int, int>;
  const auto place = [&](int corner, int edge) {
    const int high = std::max(blocks.corner_block[corner], blocks.corner_block[edge]);
    return Place(high, corner, edge);
  };
  std::size_t kept = 0;
  int i = 0, before = -1;
  for (std::size_t k = 0; k < buffers.acted.size(); ++k) {
    const auto [corner, edge] = buffers.acted[k];
    const int low = std::min(blocks.corner_block[corner], blocks.corner_block[edge]);
    if (low != before)
      i = low == 0 ? 0 : buffers.last_of_low[low - 1];
    before = low;
    const int last = buffers.last_of_low[low];
    const Place wanted = place(corner, edge);
    while (i < last && place(contacts.corner[i], contacts.edge[i]) < wanted)
      ++i;
    if (i == last || contacts.corner[i] != corner || contacts.edge[i] != edge)
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
  empty_list(model.contacts, buffers.acted, buffers.earlier);
  order_list(model.blocks, model.contacts, buffers);
  take_over(model.blocks, model.contacts, buffers);
  give_back(buffers.acted);
  give_back(buffers.last_of_low);
  update_plane_contacts(model, buffers);
  model.search.current = true;
  model.search.travel = 0.0;
  ++model.search.updates;
}

}  // namespace blocks::dynamics
