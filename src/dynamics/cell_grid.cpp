#include "dynamics/cell_grid.hpp"

#include <cmath>

#include "dynamics/give_back.hpp"

namespace blocks::dynamics {
namespace {

constexpr double cells_per_corner = 2.0;  ///< at most

}  // namespace

void CellGrid::fill(const Model& model) {
  const Blocks& blocks = model.blocks;
  const int corners = blocks.corners();
  // Square cells of the size of a block, wherever blocks may be; no more in all than
  // there is room for, nor in one row.
  const double most = std::max(1.0, cells_per_corner * corners);
  Vec2 extent = Vec2::Zero();
  if (corners > 0) {
    lower_ = blocks.corner.rowwise().minCoeff();
    extent = blocks.corner.rowwise().maxCoeff() - lower_;
  }
  const double size = corners > 0 ? blocks.area.array().sqrt().mean() : 0.0;
  const double side = std::max({size, std::sqrt(extent.x() * extent.y() / most),
                                std::max(extent.x(), extent.y()) / most});
  const auto across = [&](double length) {
    const double n = std::ceil(length / side);
    return n >= 1.0 ? static_cast<int>(std::min(n, most)) : 1;  // also if NaN
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
