// Construction and search (UPDAT) of the code of 1982.
#include "linked_list.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace blocks::bench {
namespace {

/// Equation (4) for the lightest block.
double critical_time_step(const Model& model) {
  const Settings& s = model.settings;
  return s.fraction * 2.0 *
         std::sqrt(model.blocks.mass.minCoeff() /
                   std::max(s.normal_stiffness, s.shear_stiffness));
}

}  // namespace

bool LinkedListCode::can_step(const Model& model) {
  const auto& convex = model.blocks.convex;
  return model.settings.rigid && model.settings.planes.empty() && model.loads.none() &&
         std::all_of(convex.begin(), convex.end(), [](auto one) { return bool(one); });
}

LinkedListCode::LinkedListCode(const Model& start)
    : settings_(start.settings), dt_(critical_time_step(start)) {
  const blocks::Blocks& from = start.blocks;
  if (!can_step(start))
    throw std::invalid_argument("linked lists: rigid blocks without planes and loads");
  const Vec2 size = settings_.upper - settings_.lower;
  boxes_per_length_ = {settings_.boxes_x / size.x(), settings_.boxes_y / size.y()};
  max_corners_ = 0;
  for (int b = 0; b < from.size(); ++b)
    max_corners_ = std::max(max_corners_, from.corners_of(b));
  boxes_.assign(static_cast<std::size_t>(settings_.boxes_x) * settings_.boxes_y, none);
  corners_.resize(static_cast<std::size_t>(from.size()) * max_corners_);
  for (int b = 0; b < from.size(); ++b) {
    blocks_.push_back({from.corners_of(b),
                       !from.is_free(b),
                       none,
                       from.centroid(0, b),
                       from.centroid(1, b),
                       from.velocity(0, b),
                       from.velocity(1, b),
                       from.spin[b],
                       0.0,
                       0.0,
                       0.0,
                       {},
                       from.mass[b],
                       from.inertia[b],
                       from.area[b]});
    free_ += from.is_free(b) ? 1 : 0;
    for (int k = 0; k < from.corners_of(b); ++k) {
      const int c = from.first_corner[b] + k;
      Corner& own = corner(b, k);
      own = {from.corner(0, c),
             from.corner(1, c),
             from.present_arm(c).x(),
             from.present_arm(c).y(),
             0,
             none};
      own.box = box_of(own.x, own.y);
      own.link = std::exchange(boxes_[own.box], b * max_corners_ + k);
    }
  }
  find_contacts();
  for (const blocks::Contact& contact : start.contacts) {
    const int b = from.corner_block[contact.edge];
    const int other = from.corner_block[contact.corner];
    for (int address = blocks_[b].contact; address != none;
         address = contacts_[address].link) {
      Contact& record = contacts_[address];
      if (record.block == other && record.edge == contact.edge - from.first_corner[b] &&
          record.corner == contact.corner - from.first_corner[other]) {
        record.active = true;
        record.fn = contact.normal_elastic;
        record.fs = contact.shear_elastic;
      }
    }
  }
}

Eigen::Matrix2Xd LinkedListCode::corners() const {
  std::vector<const Corner*> all;
  for (int b = 0; b < static_cast<int>(blocks_.size()); ++b)
    for (int k = 0; k < blocks_[b].corners; ++k)
      all.push_back(&corner(b, k));
  Eigen::Matrix2Xd result(2, static_cast<Eigen::Index>(all.size()));
  for (std::size_t c = 0; c < all.size(); ++c)
    result.col(static_cast<Eigen::Index>(c)) << all[c]->x, all[c]->y;
  return result;
}

int LinkedListCode::acting_contacts() const {
  return static_cast<int>(
      std::count_if(contacts_.begin(), contacts_.end(),
                    [](const Contact& record) { return record.active; }));
}

void LinkedListCode::run(long steps) {
  for (long i = 0; i < steps; ++i)
    step();
}

void LinkedListCode::find_contacts() {
  for (int b = 0; b < static_cast<int>(blocks_.size()); ++b)
    for (int edge = 0; edge < blocks_[b].corners; ++edge)
      find_contacts_of_edge(b, edge);
  update_ = false;
  travel_ = 0.0;
  ++searches_;
}

void LinkedListCode::find_contacts_of_edge(int b, int edge) {
  const Corner &p1 = corner(b, edge), &p2 = corner(b, after(b, edge));
  const double near = 2.0 * settings_.contact_tolerance;
  const double ex = p2.x - p1.x, ey = p2.y - p1.y, length2 = ex * ex + ey * ey;
  const int first = box_of(std::min(p1.x, p2.x) - near, std::min(p1.y, p2.y) - near),
            last = box_of(std::max(p1.x, p2.x) + near, std::max(p1.y, p2.y) + near);
  const int columns = settings_.boxes_x;
  for (int row = first / columns; row <= last / columns; ++row)
    for (int column = first % columns; column <= last % columns; ++column)
      for (int address = boxes_[row * columns + column]; address != none;
           address = corners_[address].link) {
        const int other = address / max_corners_, k = address % max_corners_;
        if (other == b || (blocks_[b].fixed && blocks_[other].fixed))
          continue;
        const Corner& c = corners_[address];
        const double s =
            std::clamp(((c.x - p1.x) * ex + (c.y - p1.y) * ey) / length2, 0.0, 1.0);
        const double dx = c.x - p1.x - s * ex, dy = c.y - p1.y - s * ey;
        if (dx * dx + dy * dy > near * near || listed(b, edge, other, k))
          continue;
        contacts_.push_back({edge, k, other, blocks_[b].contact, false, 0.0, 0.0, 0.0,
                             0.0, 0.0, 0.0, 0.0});
        blocks_[b].contact = static_cast<int>(contacts_.size()) - 1;
      }
}

bool LinkedListCode::listed(int b, int edge, int other, int k) const {
  for (int address = blocks_[b].contact; address != none;
       address = contacts_[address].link) {
    const Contact& record = contacts_[address];
    if (record.edge == edge && record.block == other && record.corner == k)
      return true;
  }
  return false;
}

}  // namespace blocks::bench
