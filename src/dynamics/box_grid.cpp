#include "dynamics/box_grid.hpp"

namespace blocks::dynamics {

void BoxGrid::fill(const Model& model) {
  const Settings& settings = model.settings;
  const Blocks& blocks = model.blocks;
  lower_ = settings.lower;
  boxes_x_ = settings.boxes_x;
  boxes_y_ = settings.boxes_y;
  per_x_ = boxes_x_ / (settings.upper.x() - settings.lower.x());
  per_y_ = boxes_y_ / (settings.upper.y() - settings.lower.y());

  // A counting sort: count, sum, place.
  const int corners = blocks.corners();
  first_.assign(static_cast<std::size_t>(boxes_x_) * boxes_y_ + 1, 0);
  box_.resize(corners);
  corners_.resize(corners);
  for (int c = 0; c < corners; ++c) {
    box_[c] = row(blocks.corner(1, c)) * boxes_x_ + column(blocks.corner(0, c));
    ++first_[box_[c] + 1];
  }
  for (std::size_t box = 1; box < first_.size(); ++box)
    first_[box] += first_[box - 1];
  for (int c = corners - 1; c >= 0; --c)
    corners_[--first_[box_[c] + 1]] = c;
  // each first_[box + 1] now holds the first corner of `box`: shift back by one
  for (std::size_t box = 0; box + 1 < first_.size(); ++box)
    first_[box] = first_[box + 1];
  first_.back() = corners;
}

}  // namespace blocks::dynamics
