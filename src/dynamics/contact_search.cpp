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

void find_near_corners(const Model& model, SearchBuffers& buffers, double tolerance) {
  const Blocks& blocks = model.blocks;
  BlockReach& reach = buffers.reach;
  buffers.last_of_low.assign(blocks.size() + 1, 0);
  for (int b = 0; b < blocks.size(); ++b) {
    reach.set(blocks, b, tolerance);
    buffers.grid.visit(reach.lower, reach.upper, [&](int c) {
      const Vec2 at = blocks.corner.col(c);
      if (reach.far(at))
        return;
      const int other = blocks.corner_block[c];
      if (other == b || (!blocks.is_free(b) && !blocks.is_free(other)))
        return;
      const std::size_t before = buffers.found.size();
      reach.find(at, c, buffers.found);
      if (buffers.found.size() > before)
        ++buffers.last_of_low[std::min(b, other) + 1];
    });
  }
}

/// Empties the list, all but the state of what acts, whose places are kept.
void empty_list(Contacts& contacts, std::vector<Record>& acted,
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
void each_run(const Blocks& blocks, const std::vector<Record>& found,
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

/// The blocks of a record, the lower first.
std::pair<int, int> blocks_of(const Blocks& blocks, const Record& record) {
  return std::minmax(int{blocks.corner_block[record.corner]},
                     int{blocks.corner_block[record.edge]});
}

/// Counts the runs of each lower block.
void count_runs(const Blocks& blocks, SearchBuffers& buffers) {
  buffers.last_of_low.assign(blocks.size() + 1, 0);
  each_run(blocks, buffers.found, [&](int first, int) {
    ++buffers.last_of_low[blocks_of(blocks, buffers.found[first]).first + 1];
  });
}

/// Makes the records found the list, which is empty, in its order: runs, which were
/// counted, by the lower block in one go, then those of each block by the higher one
/// and the corner. None acts.
void order_list(const Blocks& blocks, Contacts& contacts, SearchBuffers& buffers) {
  using Run = SearchBuffers::Run;
  const std::vector<Record>& found = buffers.found;
  std::vector<int>& last = buffers.last_of_low;
  std::partial_sum(last.begin(), last.end(), last.begin());
  std::vector<Run>& runs = buffers.runs;
  runs.resize(last.back());
  each_run(blocks, found, [&](int first, int behind) {
    const auto [low, high] = blocks_of(blocks, found[first]);
    const auto word = [](int number) { return static_cast<std::uint32_t>(number); };
    runs[last[low]++] = {std::uint64_t{word(high)} << 32 | word(found[first].corner),
                         first, behind};
  });
  contacts.corner.resize(found.size());
  contacts.edge.resize(found.size());
  int size = 0;
  for (int b = 0, first = 0; b < blocks.size(); ++b) {
    const int behind = last[b];
    std::sort(runs.begin() + first, runs.begin() + behind,
              [](const Run& l, const Run& r) { return l.place < r.place; });
    for (int k = std::exchange(first, behind); k < behind;) {
      const int begin = size, run = k;
      for (; k < behind && runs[k].place == runs[run].place; ++k)
        for (int i = runs[k].first; i < runs[k].last; ++i, ++size) {
          contacts.corner[size] = found[i].corner;
          contacts.edge[size] = found[i].edge;
        }
      if (k > run + 1)  // found in several pieces
        std::sort(contacts.edge.begin() + begin, contacts.edge.begin() + size);
    }
    last[b] = size;
  }
  give_back(buffers.found);
  give_back(buffers.runs);
  contacts.active.assign(contacts.corner.size(), 0);
}

/// A record that acted, and was not found: it stays at its place i in the list, so that
/// its spring may find an heir.
void keep(Contacts& contacts, std::vector<int>& last_of_low, const Record& record,
          int low, int i) {
  contacts.corner.insert(contacts.corner.begin() + i, record.corner);
  contacts.edge.insert(contacts.edge.begin() + i, record.edge);
  contacts.active.insert(contacts.active.begin() + i, false);
  for (std::size_t b = low; b < last_of_low.size(); ++b)
    ++last_of_low[b];
}

/// The state of those that acted in the list before, where they stand, at their new
/// places; the others have none. Both lists have one order. Who acted stays listed,
/// unless both blocks are fixed now.
void take_over(const Blocks& blocks, Contacts& contacts, SearchBuffers& buffers) {
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
    const auto [low, high] = blocks_of(blocks, buffers.acted[k]);
    if (low != before)
      i = low == 0 ? 0 : buffers.last_of_low[low - 1];
    before = low;
    const Place wanted = place(corner, edge);
    while (i < buffers.last_of_low[low] &&
           place(contacts.corner[i], contacts.edge[i]) < wanted)
      ++i;
    if (i == buffers.last_of_low[low] || contacts.corner[i] != corner ||
        contacts.edge[i] != edge) {
      if (!blocks.is_free(low) && !blocks.is_free(high))
        continue;
      keep(contacts, buffers.last_of_low, buffers.acted[k], low, i);
    }
    contacts.active[i] = true;
    acting[kept] = acting[k];
    acting[kept++].record = i;
  }
  acting.resize(kept);
}

void adopt_counted(Model& model, SearchBuffers& buffers, double tolerance) {
  empty_list(model.contacts, buffers.acted, buffers.earlier);
  order_list(model.blocks, model.contacts, buffers);
  take_over(model.blocks, model.contacts, buffers);
  give_back(buffers.acted);
  give_back(buffers.last_of_low);
  update_plane_contacts(model, buffers, tolerance);
  model.search.current = true;
  model.search.left = tolerance;
  ++model.search.updates;
}

}  // namespace

void update_plane_contacts(Model& model, SearchBuffers& buffers, double tolerance) {
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

double list_tolerance(const Model& model) {
  constexpr double steps_of_list = 250.0, part_of_size = 0.1;
  constexpr int many_blocks = 1 << 17;  // the list of more is as small as it may be
  const double ctol = model.settings.contact_tolerance;
  const Blocks& blocks = model.blocks;
  if (blocks.size() == 0 || blocks.size() > many_blocks)
    return ctol;
  double speed = 0.0, spin = 0.0, small = 0.0;
  for (int b = 0; b < blocks.size(); ++b) {
    const double size = std::sqrt(blocks.area[b]);
    small += 1.0 / size;  // the mean of many small ones and a large one is small
    // of fixed blocks 0
    speed = std::max(speed, blocks.velocity.col(b).squaredNorm());
    spin = std::max(spin, size * std::abs(blocks.spin[b]));
  }
  const double size = blocks.size() / small;
  const double way =
      steps_of_list * model.time_step.dt * (std::sqrt(speed) + 0.5 * spin);
  return std::max(ctol, std::min(part_of_size * size, way));  // CTOL if NaN
}

void update_contacts(Model& model, SearchBuffers& buffers) {
  const double tolerance = list_tolerance(model);
  buffers.found.clear();
  buffers.grid.fill(model);
  find_near_corners(model, buffers, tolerance);
  buffers.grid.give_back();
  adopt_counted(model, buffers, tolerance);
}

void adopt_list(Model& model, SearchBuffers& buffers, double tolerance) {
  count_runs(model.blocks, buffers);
  adopt_counted(model, buffers, tolerance);
}

}  // namespace blocks::dynamics
