#include "dynamics/cell_grid.hpp"

#include <cmath>

#include "dynamics/give_back.hpp"

namespace blocks::dynamics {

void CellGrid::fill(const Model& model) {
  const Blocks& blocks = model.blocks;
  const int corners = blocks.corners();
  // Square cells; so many across as there are four corners to each, but no more than
  // all cells were to stand in one row.
  const double cells = std::max(1.0, 0.25 * corners);
  Vec2 extent = Vec2::Zero();
  if (corners > 0) {
    lower_ = blocks.corner.rowwise().minCoeff();
    extent = blocks.corner.rowwise().maxCoeff() - lower_;
  }
  const double side = std::max(std::sqrt(extent.x() * extent.y() / cells),
                               std::max(extent.x(), extent.y()) / cells);
  const auto across = [&](double length) {
    const double n = std::ceil(length / side);
    return n >= 1.0 ? static_cast<int>(std::min(n, cells)) : 1;  // also if NaN
  };
  per_x_ = per_y_ = side > 0.0 ? 1.0 / side : 0.0;
  cells_x_ = across(extent.x());
  cells_y_ = across(extent.y());

  // A counting sort: count, sum, place.
  first_.assign(static_cast<std::size_t>(cells_x_) * cells_y_ + 1, 0);
  cell_.resize(corners);
  corners_.resize(corners);
  for (int c = 0; c < corners; ++c) {
    cell_[c] = row(blocks.corner(1, c)) * cells_x_ + column(blocks.corner(0, c));
    ++first_[cell_[c] + 1];
  }
  for (std::size_t cell = 1; cell < first_.size(); ++cell)
    first_[cell] += first_[cell - 1];
  for (int c = corners - 1; c >= 0; --c)
    corners_[--first_[cell_[c] + 1]] = c;
  // each first_[cell + 1] now holds the first corner of `cell`: shift back by one
  for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell)
    first_[cell] = first_[cell + 1];
  first_.back() = corners;
}

void CellGrid::give_back() {
  for (std::vector<int>* column : {&first_, &corners_, &cell_})
    dynamics::give_back(*column);
}

}  // namespace blocks::dynamics
