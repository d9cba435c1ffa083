#include "geometry/shared_corners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "geometry/exact/box_pairs.hpp"
#include "geometry/exact/kernels.hpp"
#include "geometry/exact/numbers.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

using Key = std::pair<double, double>;

Key key_of(const Vec2& p) { return {p.x() + 0.0, p.y() + 0.0}; }

bool has_slanted_side(const DeckOutline& outline) {
  const std::vector<DecimalPoint>& corners = outline.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const DecimalPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if (a.x.value() != b.x.value() && a.y.value() != b.y.value())
      return true;
  }
  return false;
}

// One copy of an outline, clockwise, with the nearest doubles as corners.
struct Copy {
  const DeckOutline* from;
  int number;
  bool reversed;
};

// A corner strictly inside the side a -> b of another outline, which is on the right of
// that side.
struct Touch {
  Key corner, a, b;
  auto operator<=>(const Touch&) const = default;
};

exact::Point exact_corner(const Copy& copy, std::size_t corner) {
  const std::size_t n = copy.from->corners.size();
  const std::size_t i = copy.reversed && corner > 0 ? n - corner : corner;
  const exact::Point shift = exact::rational(copy.from->shift);
  return exact::rational(copy.from->corners[i]) +
         exact::Vector(shift.x() * copy.number, shift.y() * copy.number);
}

// Tests whether the corner is as close to the line a -> b as rounding can have moved a
// point of that line.
bool may_touch(const Vec2& corner, const Vec2& a, const Vec2& b) {
  const Vec2 side = b - a;
  const double reach =
      0x1p-48 * (corner.cwiseAbs() + a.cwiseAbs() + b.cwiseAbs()).sum();
  return std::abs(cross(side, corner - a)) <= reach * side.lpNorm<1>() &&
         (corner - a).dot(corner - b) < 0.0;
}

bool touches(const exact::Point& corner, const exact::Point& a, const exact::Point& b) {
  return CGAL::collinear(a, corner, b) &&
         CGAL::collinear_are_strictly_ordered_along_line(a, corner, b);
}

// A corner moves by at most this many units in the last place of the largest coordinate
// at a time.
constexpr double max_units = 64.0;

// Moves the corners of all touches out of the sides that they touch.
class Mover {
 public:
  Mover(std::set<Touch> touches, const std::vector<Polygon>& outlines)
      : touches_(std::move(touches)) {
    for (const Touch& touch : touches_)
      axes_[touch.corner];
    for (const Polygon& outline : outlines)
      for (std::size_t i = 0; i < outline.size(); ++i)
        note_axis(outline[i], outline[(i + 1) % outline.size()]);
    // Each round starts from the moves of the round before. A cycle of touches that
    // never settles is left to the certificate.
    bool moving = true;
    for (int round = 0; round < 64 && moving; ++round) {
      moving = false;
      for (const Touch& touch : touches_)
        moving = leave(touch) || moving;
    }
  }
  std::map<Key, Vec2> places() && { return std::move(places_); }

 private:
  struct Axes {
    bool horizontal = false, vertical = false;
  };

  Vec2 place(const Key& corner) const {
    const auto found = places_.find(corner);
    return found == places_.end() ? Vec2(corner.first, corner.second) : found->second;
  }
  void note_axis(const Vec2& a, const Vec2& b) {
    for (const Vec2& end : {a, b})
      if (const auto found = axes_.find(key_of(end)); found != axes_.end()) {
        found->second.horizontal = found->second.horizontal || a.y() == b.y();
        found->second.vertical = found->second.vertical || a.x() == b.x();
      }
  }
  // Moves the corner of the touch out of the side if it is inside; returns whether it
  // moved.
  bool leave(const Touch& touch) {
    const Vec2 a = place(touch.a), b = place(touch.b);
    const auto inside = [&](const Vec2& p) {
      return CGAL::orientation(exact::point(a), exact::point(b), exact::point(p)) ==
             CGAL::RIGHT_TURN;
    };
    const Vec2 from = place(touch.corner);
    if (!inside(from))
      return false;
    const Vec2 out(a.y() - b.y(), b.x() - a.x());
    const Axes axes = axes_.at(touch.corner);
    const int steeper = std::abs(out.x()) > std::abs(out.y()) ? 0 : 1;
    const int kept = axes.horizontal == axes.vertical ? steeper
                     : axes.horizontal                ? 0
                                                      : 1;
    for (const int axis : {kept, steeper}) {
      const double largest =
          std::max(a.lpNorm<Eigen::Infinity>(), from.lpNorm<Eigen::Infinity>());
      double step =
          std::nextafter(largest, std::numeric_limits<double>::max()) - largest;
      for (; step <= max_units * 0x1p-52 * largest && out[axis] != 0.0; step *= 2.0) {
        Vec2 to = from;
        to[axis] += std::copysign(step, out[axis]);
        if (inside(to))
          continue;
        places_[touch.corner] = to;
        return true;
      }
    }
    return false;  // left to the certificate
  }

  std::set<Touch> touches_;
  std::map<Key, Axes> axes_;
  std::map<Key, Vec2> places_;
};

}  // namespace

SharedCorners::SharedCorners(const std::vector<DeckOutline>& outlines) {
  if (std::none_of(outlines.begin(), outlines.end(), has_slanted_side))
    return;
  std::vector<Copy> copies;
  std::vector<Polygon> placed;
  for (const DeckOutline& outline : outlines)
    for (int copy = 0; copy < outline.copies; ++copy) {
      Polygon corners = place_outline(outline.corners, outline.shift, copy);
      const bool clockwise = section_properties(corners).area > 0.0;
      placed.push_back(clockwise ? std::move(corners) : reversed(corners));
      copies.push_back({&outline, copy, !clockwise});
    }
  std::set<Touch> touching;
  const auto corners_of = [&](std::size_t i, std::size_t j) {
    for (std::size_t c = 0; c < placed[i].size(); ++c)
      for (std::size_t k = 0; k < placed[j].size(); ++k) {
        const std::size_t l = (k + 1) % placed[j].size();
        const Vec2 &corner = placed[i][c], &a = placed[j][k], &b = placed[j][l];
        if (may_touch(corner, a, b) &&
            touches(exact_corner(copies[i], c), exact_corner(copies[j], k),
                    exact_corner(copies[j], l)))
          touching.insert({key_of(corner), key_of(a), key_of(b)});
      }
  };
  exact::for_each_close_pair(placed, {}, [&](std::size_t i, std::size_t j) {
    corners_of(i, j);
    corners_of(j, i);
  });
  if (!touching.empty())
    places_ = Mover(std::move(touching), placed).places();
}

Vec2 SharedCorners::place(const Vec2& nearest) const {
  const auto found = places_.find(key_of(nearest));
  return found == places_.end() ? nearest : found->second;
}

}  // namespace blocks::geometry
