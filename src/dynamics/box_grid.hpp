// The grid of boxes over the domain and which corners lie in which (report 3.1).
#pragma once

#include <algorithm>
#include <vector>

#include "model/model.hpp"

namespace blocks::dynamics {

class BoxGrid {
 public:
  /// Sorts all corners into the boxes. Corners outside the domain go to the nearest
  /// box.
  void fill(const Model& model);

  /// Calls visit(corner) for every corner in the boxes touched by the rectangle.
  template <class Visit>
  void visit(const Vec2& lower, const Vec2& upper, Visit visit) const {
    const int i0 = column(lower.x()), i1 = column(upper.x());
    const int j0 = row(lower.y()), j1 = row(upper.y());
    for (int j = j0; j <= j1; ++j) {
      // boxes i0..i1 of a row stand side by side
      const int first = first_[j * boxes_x_ + i0], last = first_[j * boxes_x_ + i1 + 1];
      for (int k = first; k < last; ++k)
        visit(corners_[k]);
    }
  }

  int column(double x) const { return index(x - lower_.x(), per_x_, boxes_x_); }
  int row(double y) const { return index(y - lower_.y(), per_y_, boxes_y_); }

 private:
  static int index(double distance, double per, int boxes) {
    const double at = distance * per;
    return at > 0.0 ? static_cast<int>(std::min(at, boxes - 1.0)) : 0;  // also if NaN
  }

  Vec2 lower_ = Vec2::Zero();
  double per_x_ = 1.0, per_y_ = 1.0;  ///< boxes per length [1/L]
  int boxes_x_ = 1, boxes_y_ = 1;
  std::vector<int> first_;    ///< (boxes + 1) first corner of each box
  std::vector<int> corners_;  ///< (m) corners, box by box
  std::vector<int> box_;      ///< (m) box of each corner
};

}  // namespace blocks::dynamics
