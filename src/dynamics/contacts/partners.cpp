#include "dynamics/contacts/partners.hpp"

#include "geometry/contact_constants.hpp"

namespace blocks::dynamics {

void add_partners(const Blocks& blocks, std::vector<PairContact>& contacts) {
  constexpr double square_of_cosine = geometry::face_cosine * geometry::face_cosine;
  const auto faces = [&](const Vec2& side, const Vec2& edge) {
    const double along = side.dot(edge);
    return along > 0.0 &&
           along * along >= square_of_cosine * side.squaredNorm() * edge.squaredNorm();
  };
  const std::vector<PairContact> given = contacts;
  for (const PairContact& contact : given) {
    const auto [corner, edge] = contact.at;
    const int edge_end = blocks.next[edge], before = blocks.previous[corner];
    const auto from_to = [&](int from, int to) -> Vec2 {
      return blocks.corner.col(to) - blocks.corner.col(from);
    };
    const Vec2 along = from_to(edge, edge_end);
    if (faces(from_to(corner, before), along))
      add_in_order(contacts, {edge, before});
    if (faces(from_to(blocks.next[corner], corner), along))
      add_in_order(contacts, {edge_end, corner});
  }
}

}  // namespace blocks::dynamics
