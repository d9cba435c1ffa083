#include "run/builder/face_joints.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace blocks::run {

void give_layer_joints(const deck::FaceIds& ids, NewBlock& block) {
  if (!ids.given())
    return;
  const int side = static_cast<int>(ids.side.value);
  block.joints = {side, static_cast<int>(ids.top.value), side,
                  static_cast<int>(ids.bottom.value)};
}

void give_face_joints(const deck::FaceIds& ids, NewBlock& block) {
  if (!ids.given())
    return;
  const std::size_t sides = block.outline.size();
  block.joints.resize(sides, 0);
  for (std::size_t i = 0; i < sides; ++i) {
    if (block.joints[i] != 0)
      continue;
    // Corners are clockwise, so the block is on the right: a top runs to the right.
    const Vec2 along = block.outline[(i + 1) % sides] - block.outline[i];
    const deck::Int& id = along.x() > std::abs(along.y())    ? ids.top
                          : -along.x() > std::abs(along.y()) ? ids.bottom
                                                             : ids.side;
    block.joints[i] = static_cast<int>(id.value);
  }
}

std::string between_joints(const std::vector<int>& joints) {
  std::set<int> ids(joints.begin(), joints.end());
  ids.erase(0);
  return ids.empty()
             ? std::string()
             : fmt::format(" {} {}", ids.size() == 1 ? "at joint" : "between joints",
                           fmt::join(ids, ", "));
}

}  // namespace blocks::run
