#include "study/near_corners.hpp"

#include <algorithm>

namespace blocks::study {
namespace {

double distance_to_segment(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const Vec2 along = p2 - p1;
  const double s = std::clamp((c - p1).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (c - p1 - s * along).norm();
}

}  // namespace

void NearCorners::find(const Model& model, const dynamics::PairIndex& index,
                       double reach) {
  const Blocks& blocks = model.blocks;
  listed_.clear();
  for (const dynamics::NearPair& pair : index.pairs) {
    add_near(blocks, pair.low, pair.high, reach);
    add_near(blocks, pair.high, pair.low, reach);
  }
  for (const Contact& contact : model.contacts)
    add(blocks, contact.corner, contact.edge);
}

void NearCorners::add(const Blocks& blocks, int corner, int edge) {
  Corners& own = listed_[std::minmax(int{blocks.corner_block[corner]},
                                     int{blocks.corner_block[edge]})];
  const dynamics::CornerOnEdge one{corner, edge};
  if (std::find(own.begin(), own.end(), one) == own.end())
    own.push_back(one);
}

/// Lists the corners of block `own` that are near edges of the other block.
void NearCorners::add_near(const Blocks& blocks, int own, int other, double reach) {
  for (int c = blocks.first_corner[own]; c < blocks.first_corner[own + 1]; ++c)
    for (int e = blocks.first_corner[other]; e < blocks.first_corner[other + 1]; ++e)
      if (distance_to_segment(blocks.corner.col(c), blocks.corner.col(e),
                              blocks.corner.col(blocks.next[e])) <= reach)
        add(blocks, c, e);
}

const NearCorners::Corners& NearCorners::of(int low, int high) const {
  static const Corners none;
  const auto found = listed_.find({low, high});
  return found == listed_.end() ? none : found->second;
}

}  // namespace blocks::study
