#include "dynamics/preparation/face_loads.hpp"

#include <algorithm>
#include <cstddef>

namespace blocks::dynamics {

EdgeFrame::EdgeFrame(const Blocks& blocks, int edge) {
  const Vec2 side = blocks.corner.col(blocks.next[edge]) - blocks.corner.col(edge);
  along = side / side.norm();
  outwards = {-along.y(), along.x()};
}

Vec2 force_on_corner(const Blocks& blocks, const Contact& contact) {
  const EdgeFrame edge(blocks, contact.edge);
  return contact.normal_force * edge.outwards - contact.shear_force * edge.along;
}

Vec2 force_on_corner(const Plane& plane, const PlaneContact& contact) {
  const Vec2 along = (plane.b - plane.a).normalized();
  return contact.normal_force * Vec2(-along.y(), along.x());
}

void PairLoads::add(const Face& face) {
  const double slack = same_point * face.length_of_side();
  const FaceEnd ends[2] = {face.end(false, slack), face.end(true, slack)};
  Eigen::Matrix2d stress[2];
  for (int i = 0; i < 2; ++i)
    stress[i] = field_.at(blocks_.corner(1, ends[i].records[0].corner));
  for (int i = 0; i < 2; ++i) {
    const Eigen::Matrix2d force =
        (face.common() / 6.0) * (2.0 * stress[i] + stress[1 - i]);
    for (int k = 0; k < ends[i].count; ++k)
      add(ends[i].records[static_cast<std::size_t>(k)], force / ends[i].count);
  }
}

/// force: stress times length. -force * outwards acts on the block of the corner.
void PairLoads::add(const CornerOnEdge& at, const Eigen::Matrix2d& force) {
  const EdgeFrame edge(blocks_, at.edge);
  auto found = std::find_if(all_.begin(), all_.end(),
                            [&](const FaceLoad& one) { return one.at == at; });
  if (found == all_.end())
    found = all_.insert(all_.end(), {at});
  found->normal -= edge.outwards.dot(force * edge.outwards);
  found->shear += edge.along.dot(force * edge.outwards);
}

}  // namespace blocks::dynamics
