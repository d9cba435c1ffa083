// A grid of cells over the blocks and which corners lie in which: the boxes of report
// 3.1. Their size follows from the blocks, so that no BOXES card makes a run slow.
#pragma once

#include <algorithm>
#include <vector>

#include "model/model.hpp"

namespace blocks::dynamics {

class CellGrid {
 public:
  /// Sorts all corners into cells as large as a block, the mean of sqrt(area), or
  /// larger: two cells to a corner at most.
  void fill(const Model& model);

  /// Forgets the corners, until they are sorted again.
  void give_back();

  /// Calls visit(corner) for every corner in the cells touched by the rectangle.
  template <class Visit>
  void visit(const Vec2& lower, const Vec2& upper, Visit visit) const {
    const int i0 = column(lower.x()), i1 = column(upper.x());
    const int j0 = row(lower.y()), j1 = row(upper.y());
    for (int j = j0; j <= j1; ++j) {
      // cells i0..i1 of a row stand side by side
      const int first = first_[j * cells_x_ + i0], last = first_[j * cells_x_ + i1 + 1];
      for (int k = first; k < last; ++k)
        visit(corners_[k]);
    }
  }

  int column(double x) const { return index(x - lower_.x(), per_x_, cells_x_); }
  int row(double y) const { return index(y - lower_.y(), per_y_, cells_y_); }

 private:
  static int index(double distance, double per, int cells) {
    const double at = distance * per;
    return at > 0.0 ? static_cast<int>(std::min(at, cells - 1.0)) : 0;  // also if NaN
  }

  Vec2 lower_ = Vec2::Zero();
  double per_x_ = 1.0, per_y_ = 1.0;  ///< cells per length [1/L]
  int cells_x_ = 1, cells_y_ = 1;
  std::vector<int> first_;    ///< (cells + 1) first corner of each cell
  std::vector<int> corners_;  ///< (m) corners, cell by cell
  std::vector<int> cell_;     ///< (m) cell of each corner
};

}  // namespace blocks::dynamics
