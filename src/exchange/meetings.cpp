#include "exchange/meetings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "geometry/contact_predicates.hpp"

namespace blocks::exchange {
namespace {

using geometry::Polygon;
using geometry::Vec2;

struct CornerRef {
  int block, corner;
  Vec2 place;
};

/// Corners sorted into the cells of a grid, about one to a cell.
class CornerGrid {
 public:
  CornerGrid(const std::vector<Polygon>& outlines) {
    for (int b = 0; b < static_cast<int>(outlines.size()); ++b)
      for (int c = 0; c < static_cast<int>(outlines[b].size()); ++c)
        if (outlines[b][c].allFinite())
          corners_.push_back({b, c, outlines[b][c]});
    lower_ = upper_ = corners_.empty() ? Vec2(0, 0) : corners_[0].place;
    for (const CornerRef& corner : corners_) {
      lower_ = lower_.cwiseMin(corner.place);
      upper_ = upper_.cwiseMax(corner.place);
    }
    cells_ = std::clamp(static_cast<int>(std::sqrt(corners_.size())), 1, 4000);
    const auto cell_of = [&](const CornerRef& corner) {
      return column(corner.place.x()) * cells_ + row(corner.place.y());
    };
    std::stable_sort(corners_.begin(), corners_.end(),
                     [&](const CornerRef& a, const CornerRef& b) {
                       return cell_of(a) < cell_of(b);
                     });
    first_.assign(static_cast<std::size_t>(cells_) * cells_ + 1, 0);
    for (const CornerRef& corner : corners_)
      ++first_[cell_of(corner) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i)
      first_[i] += first_[i - 1];
  }

  double size() const { return (upper_ - lower_).norm(); }

  /// action for the corners of every cell that the box from lower to upper touches.
  template <class Action>
  void visit(const Vec2& lower, const Vec2& upper, Action action) const {
    for (int i = column(lower.x()); i <= column(upper.x()); ++i)
      for (int k = first_[i * cells_ + row(lower.y())];
           k < first_[i * cells_ + row(upper.y()) + 1]; ++k)
        action(corners_[k]);
  }

 private:
  std::vector<CornerRef> corners_;
  std::vector<int> first_;
  Vec2 lower_, upper_;
  int cells_ = 1;

  int index(double x, double from, double to) const {
    const double part = to > from ? (x / 2 - from / 2) / (to / 2 - from / 2) : 0.0;
    // Clamped before it becomes an int: a slender whole grown by `near` leaves it far.
    return std::min(static_cast<int>(std::clamp(part, 0.0, 1.0) * cells_), cells_ - 1);
  }
  int column(double x) const { return index(x, lower_.x(), upper_.x()); }
  int row(double y) const { return index(y, lower_.y(), upper_.y()); }
};

bool has_corner(const Polygon& outline, const Vec2& point) {
  return std::find(outline.begin(), outline.end(), point) != outline.end();
}

/// Two points near each other meet from either side, and in every block they belong to.
void keep_one_for_each_pair_of_points(const std::vector<Polygon>& outlines,
                                      std::vector<Meeting>& meetings) {
  std::set<std::array<double, 4>> seen;
  std::erase_if(meetings, [&](const Meeting& meeting) {
    std::array<double, 2> p{meeting.place.x(), meeting.place.y()};
    const Vec2& other = outlines[meeting.other][meeting.side];
    std::array<double, 2> q{other.x(), other.y()};
    if (q < p)
      std::swap(p, q);
    return !seen.insert({p[0], p[1], q[0], q[1]}).second;
  });
}

}  // namespace

void find_meetings(const std::vector<Polygon>& outlines, Soundness& result) {
  const CornerGrid grid(outlines);
  const double near = meeting_tolerance * grid.size();
  if (!std::isfinite(near))
    return;  // a domain wider than doubles can measure
  for (int b = 0; b < static_cast<int>(outlines.size()); ++b) {
    const Polygon& outline = outlines[b];
    for (int s = 0; s < static_cast<int>(outline.size()); ++s) {
      const Vec2& a = outline[s];
      const Vec2& e = outline[(s + 1) % outline.size()];
      if (!a.allFinite() || !e.allFinite())
        continue;
      const Vec2 grown(near, near);
      grid.visit(a.cwiseMin(e) - grown, a.cwiseMax(e) + grown, [&](const CornerRef& c) {
        if (c.block == b || has_corner(outline, c.place))
          return;
        const double from_a = (c.place - a).norm(), from_e = (c.place - e).norm();
        if (from_a <= near) {
          result.near_corners.push_back({c.block, c.corner, b, s, from_a, c.place});
          return;
        }
        const Vec2 along = e - a;
        const double t = (c.place - a).dot(along);
        if (from_e <= near || !(t > 0 && t < along.squaredNorm()))
          return;
        const double off = std::abs(geometry::cross(along, c.place - a)) / along.norm();
        if (off > near)
          return;
        const bool exact = geometry::overlap_sign(c.place, a, e) == 0;
        result.on_sides.push_back(
            {c.block, c.corner, b, s, exact ? 0.0 : off, c.place});
      });
    }
  }
  const auto by_number = [](const Meeting& a, const Meeting& b) {
    return std::array{a.block, a.corner, a.other, a.side} <
           std::array{b.block, b.corner, b.other, b.side};
  };
  std::sort(result.on_sides.begin(), result.on_sides.end(), by_number);
  std::sort(result.near_corners.begin(), result.near_corners.end(), by_number);
  keep_one_for_each_pair_of_points(outlines, result.near_corners);
}

}  // namespace blocks::exchange
