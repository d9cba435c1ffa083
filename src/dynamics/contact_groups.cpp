#include "dynamics/contact_groups.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {

void group_contacts(const Contacts& contacts, std::vector<ContactGroup>& groups) {
  groups.clear();
  const int size = contacts.size();
  for (int first = 0, last; first < size; first = last) {
    last = first + 1;
    while (last < size && contacts.corner[last] == contacts.corner[first] &&
           contacts.edge_block[last] == contacts.edge_block[first])
      ++last;
    groups.push_back({first, last, 0.0});
  }
}

double travel_before_contact(const Blocks& blocks, int corner, int block) {
  if (!blocks.convex[block])
    return 0.0;
  const Vec2 c = blocks.corner.col(corner);
  double travel = 0.0;
  for (int e = blocks.first_corner[block]; e < blocks.first_corner[block + 1]; ++e) {
    const Vec2 p = blocks.corner.col(e);
    const Vec2 along = Vec2(blocks.corner.col(blocks.next[e])) - p;
    const double square = along.squaredNorm();
    const double outside = -geometry::cross(c - p, along);  // gap times L
    // well clear of the slack of rules 10 and 12, and of round-off
    if (outside <= 16.0 * geometry::contact_slack * square)
      continue;
    const double length = std::sqrt(square), q = (c - p).dot(along) / square;
    const double factor = 1.0 + std::abs(1.0 - q) + std::abs(q);
    travel =
        std::max(travel, std::min(0.75 * outside / (length * factor), 0.2 * length));
  }
  return travel;
}

}  // namespace blocks::dynamics
