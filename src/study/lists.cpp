#include "study/lists.hpp"

#include <algorithm>

namespace blocks::study {
namespace {

using dynamics::SearchBuffers;

double distance_to_segment(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const Vec2 along = p2 - p1;
  const double s = std::clamp((c - p1).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (c - p1 - s * along).norm();
}

void find_near(Model& model, SearchBuffers& buffers, bool keep) {
  const Blocks& blocks = model.blocks;
  const double reach = 2.0 * model.settings.contact_tolerance;
  buffers.found.clear();
  buffers.grid.fill(model);
  for (int e = 0; e < blocks.corners(); ++e) {
    const int b = blocks.corner_block[e];
    const Vec2 p1 = blocks.corner.col(e), p2 = blocks.corner.col(blocks.next[e]);
    const Vec2 lower = p1.cwiseMin(p2).array() - reach;
    const Vec2 upper = p1.cwiseMax(p2).array() + reach;
    buffers.grid.visit(lower, upper, [&](int c) {
      const int other = blocks.corner_block[c];
      if (other != b && (blocks.is_free(b) || blocks.is_free(other)) &&
          distance_to_segment(blocks.corner.col(c), p1, p2) <= reach)
        buffers.found.push_back({c, e});
    });
  }
  if (!keep)
    return;
  const Contacts& old = model.contacts;
  for (int i = 0; i < old.size(); ++i)
    buffers.found.push_back({old.corner[i], old.edge[i]});
  std::sort(buffers.found.begin(), buffers.found.end());
  buffers.found.erase(std::unique(buffers.found.begin(), buffers.found.end()),
                      buffers.found.end());
}

}  // namespace

void find_contacts(Model& model, SearchBuffers& buffers, List list, bool each_alone) {
  if (!model.search.current) {
    if (list == List::reach) {
      update_contacts(model, buffers);
    } else {
      find_near(model, buffers, list == List::kept);
      adopt_list(model, buffers, model.settings.contact_tolerance);
    }
  }
  if (buffers.grouped_update != model.search.updates) {
    group_contacts(model.blocks, model.contacts, model.settings.rigid, buffers.groups,
                   each_alone);
    buffers.grouped_update = model.search.updates;
  }
}

}  // namespace blocks::study
