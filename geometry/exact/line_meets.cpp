#include "geometry/exact/line_meets.hpp"

#include <algorithm>

namespace blocks::geometry::exact {
namespace {

// Products above this are not affected by underflow, see certain_side.
constexpr double min_product = 1e-270;

// The sides of the line on which the corners lie, and their places along the line.
class LineAndCorners {
 public:
  LineAndCorners(const Polygon& outline, const SplitLine& line)
      : outline_(outline), line_(line) {
    place_unit_.see(line.point);
    for (const Vec2& corner : outline)
      place_unit_.see(corner);
    along_unit_.see(line.along);
    along_x_ = along_unit_(line.along.x());
    along_y_ = along_unit_(line.along.y());
    point_x_ = place_unit_(line.point.x());
    point_y_ = place_unit_(line.point.y());
  }

  // Returns 1 if the corner is left of the line, -1 if it is on the right, 0 on the
  // line.
  int side_of(std::size_t corner) const {
    if (const int side = certain_side(outline_[corner]); side != 0)
      return side;
    return static_cast<int>(CGAL::sign(offset(corner).left));
  }

  // Distances from the line to the left and along the line from its point, both times
  // the length of line.along, as integers.
  struct Offset {
    Integer left, along;
  };
  Offset offset(std::size_t corner) const {
    Integer x = place_unit_(outline_[corner].x());
    Integer y = place_unit_(outline_[corner].y());
    mpz_sub(x.mpz(), x.mpz(), point_x_.mpz());
    mpz_sub(y.mpz(), y.mpz(), point_y_.mpz());
    Offset offset;
    mpz_mul(offset.left.mpz(), along_x_.mpz(), y.mpz());
    mpz_submul(offset.left.mpz(), along_y_.mpz(), x.mpz());
    mpz_mul(offset.along.mpz(), along_x_.mpz(), x.mpz());
    mpz_addmul(offset.along.mpz(), along_y_.mpz(), y.mpz());
    return offset;
  }

 private:
  // Returns the side if doubles determine it, otherwise 0. Each product has an error
  // of two roundings and their difference of one more, so that the error is below
  // (3 + 8 u) u (|a| + |b|), u = 2^-53.
  int certain_side(const Vec2& corner) const {
    const double a = line_.along.x() * (corner.y() - line_.point.y());
    const double b = line_.along.y() * (corner.x() - line_.point.x());
    const double sum = std::abs(a) + std::abs(b);
    const double left = a - b;
    if (!(sum > min_product) || !(std::abs(left) > 0x1p-51 * sum) ||
        !std::isfinite(sum))
      return 0;
    return left > 0.0 ? 1 : -1;
  }

  const Polygon& outline_;
  const SplitLine& line_;
  BinaryUnit place_unit_, along_unit_;
  Integer along_x_, along_y_, point_x_, point_y_;
};

}  // namespace

std::vector<LineMeet> meets_of_line(const Polygon& outline, const SplitLine& line) {
  const LineAndCorners corners(outline, line);
  const std::size_t n = outline.size();
  std::vector<int> sides(n);
  for (std::size_t i = 0; i < n; ++i)
    sides[i] = corners.side_of(i);
  std::vector<LineMeet> meets;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    LineMeet meet;
    if (sides[i] == 0) {
      // A parallel line on the left crosses the outline beside this corner if one of
      // its neighbours is on the left and the other is not.
      const int before = sides[(i + n - 1) % n], after = sides[j];
      meet.corner = static_cast<int>(i);
      meet.along = {corners.offset(i).along, 1};
      meet.left = (before > 0) != (after > 0);
      meet.right = (before < 0) != (after < 0);
      meets.push_back(std::move(meet));
    } else if (sides[i] * sides[j] < 0) {
      const auto a = corners.offset(i), b = corners.offset(j);
      const Integer width = a.left - b.left;
      meet.side = static_cast<int>(i);
      meet.part = {a.left, width};
      meet.along = {a.left * b.along - b.left * a.along, width};
      meets.push_back(std::move(meet));
    }
  }
  std::sort(meets.begin(), meets.end(),
            [](const LineMeet& a, const LineMeet& b) { return a.along < b.along; });
  return meets;
}

std::optional<std::pair<LineMeet, LineMeet>>
nearest_chord(const std::vector<LineMeet>& meets) {
  // Between two meets the line is inside the outline if lines infinitesimally beside it
  // are inside on its left and on its right. If only one is, the line follows a side.
  std::optional<std::size_t> best;
  Fraction min;
  bool left = false, right = false;
  for (std::size_t k = 0; k + 1 < meets.size(); ++k) {
    left ^= meets[k].left;
    right ^= meets[k].right;
    if (!left || !right)
      continue;
    const Fraction &first = meets[k].along, &last = meets[k + 1].along;
    Fraction distance;
    if (first.num > 0)
      distance = first;
    else if (last.num < 0)
      distance = {-last.num, last.den};
    if (!best || distance < min) {
      best = k;
      min = distance;
    }
  }
  if (!best)
    return std::nullopt;
  return std::pair(meets[*best], meets[*best + 1]);
}

}  // namespace blocks::geometry::exact
