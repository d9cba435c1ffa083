#include "geometry/split.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/exact/line_meets.hpp"
#include "geometry/exact/rounded_line.hpp"
#include "geometry/numeric_environment.hpp"

namespace blocks::geometry {
namespace {

using exact::BinaryUnit;
using exact::Fraction;
using exact::Integer;
using exact::LineMeet;
using exact::Rational;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool is_usable(const Polygon& outline, const SplitLine& line) {
  return outline.size() >= 3 && line.point.allFinite() && line.along.allFinite() &&
         line.along != Vec2::Zero() &&
         std::all_of(outline.begin(), outline.end(),
                     [](const Vec2& corner) { return corner.allFinite(); });
}

// Returns the length of a vector. Lengths whose square is out of the range of doubles
// are no exception.
double length_of(const Vec2& v) {
  const double largest = std::max(std::abs(v.x()), std::abs(v.y()));
  if (largest == 0.0 || !std::isfinite(largest))
    return largest;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const Vec2 scaled(std::ldexp(v.x(), -exponent), std::ldexp(v.y(), -exponent));
  return std::ldexp(std::sqrt(scaled.squaredNorm()), exponent);
}

// Makes the ends of the chord: rounds crossings or moves them to corners.
class EndMaker {
 public:
  EndMaker(const Polygon& outline, double near) : outline_(outline), near_(near) {}

  ChordEnd end(const LineMeet& meet) const {
    if (meet.corner >= 0)
      return at_corner(index(meet.corner), 0.0);
    const std::size_t i = index(meet.side), j = (i + 1) % outline_.size();
    const Integer twice = meet.part.num * 2;
    const bool first = twice < meet.part.den || (twice == meet.part.den && i < j);
    const Fraction rest(meet.part.den - meet.part.num, meet.part.den);
    if (is_near(first ? meet.part : rest, i, j))
      return at_corner(first ? i : j, distance(first ? meet.part : rest, i, j));
    ChordEnd end;
    end.place = rounded(rest, i, j);
    for (const std::size_t corner : {i, j})
      if (end.place == outline_[corner])
        return at_corner(corner, distance(corner == i ? meet.part : rest, i, j));
    end.side = meet.side;
    end.part = exact::rounded_towards(meet.part, 0);
    return end;
  }

 private:
  ChordEnd at_corner(std::size_t corner, double moved) const {
    ChordEnd end;
    end.place = outline_[corner];
    end.corner = static_cast<int>(corner);
    end.moved = moved;
    return end;
  }
  double distance(const Fraction& part, std::size_t i, std::size_t j) const {
    return exact::rounded_towards(part, 0) * length_of(outline_[j] - outline_[i]);
  }
  // Tests exactly whether this part of the side is shorter than `near`. Doubles decide
  // if they differ by more than their errors, which are below 10 roundings.
  bool is_near(const Fraction& part, std::size_t i, std::size_t j) const {
    if (!(near_ > 0.0))
      return false;
    if (std::isinf(near_))
      return true;
    const double length = distance(part, i, j);
    if (length > 1e-290 && length < 1e290 &&
        std::abs(length - near_) > 0x1p-48 * length)
      return length < near_;
    const Rational exactly = part.reduced(), near(near_);
    const Vec2 &a = outline_[i], &b = outline_[j];
    const Rational x = Rational(b.x()) - Rational(a.x());
    const Rational y = Rational(b.y()) - Rational(a.y());
    return exactly * exactly * (x * x + y * y) < near * near;
  }
  // The block is on the right of its sides, so the line runs from the second corner to
  // the first. rest: part of the side from the second corner.
  Vec2 rounded(const Fraction& rest, std::size_t i, std::size_t j) const {
    const exact::RoundedLine line(outline_[j], outline_[i]);
    return line.at(rest) + Vec2(0.0, 0.0);  // no -0
  }

  const Polygon& outline_;
  double near_;
};

// Tests whether a new corner is not outside its side and strictly between its corners.
bool is_on_side(const ChordEnd& end, const Polygon& outline) {
  if (end.side < 0)
    return true;
  const std::size_t i = index(end.side), j = (i + 1) % outline.size();
  const auto a = exact::point(outline[i]), b = exact::point(outline[j]);
  const auto place = exact::point(end.place);
  return CGAL::orientation(a, b, place) != CGAL::LEFT_TURN &&
         CGAL::angle(place, a, b) == CGAL::ACUTE &&
         CGAL::angle(place, b, a) == CGAL::ACUTE;
}

// A piece as vertices of the mesh: the n corners of the outline, then the new corners
// of the two ends.
struct PieceLoop {
  std::vector<int> vertices;
  std::vector<int> sides;
};

// The old outline and the two pieces as loops of vertices.
class Loops {
 public:
  Loops(const Polygon& outline, const std::array<ChordEnd, 2>& ends)
      : count_(static_cast<int>(outline.size())), ends_(ends) {}

  int vertex(std::size_t end) const {
    const int corner = ends_[end].corner;
    return corner >= 0 ? corner : count_ + static_cast<int>(end);
  }
  // Returns the piece between the ends `from` and `to`, clockwise along the outline and
  // back along the chord. It begins with its lowest corner of the old outline.
  PieceLoop piece(std::size_t from, std::size_t to) const {
    PieceLoop loop;
    const auto add = [&loop](int vertex, int side) {
      loop.vertices.push_back(vertex);
      loop.sides.push_back(side);
    };
    const ChordEnd &start = ends_[from], &stop = ends_[to];
    const int first = start.corner >= 0 ? start.corner : start.side;
    add(vertex(from), first);
    // A new corner comes after the first corner of its side.
    const int last = stop.corner >= 0 ? (stop.corner + count_ - 1) % count_ : stop.side;
    for (int i = first; i != last;) {
      i = (i + 1) % count_;
      add(i, i);
    }
    add(vertex(to), -1);
    const auto lowest = std::min_element(loop.vertices.begin(), loop.vertices.end()) -
                        loop.vertices.begin();
    std::rotate(loop.vertices.begin(), loop.vertices.begin() + lowest,
                loop.vertices.end());
    std::rotate(loop.sides.begin(), loop.sides.begin() + lowest, loop.sides.end());
    return loop;
  }
  std::vector<int> outline() const {
    std::vector<int> loop;
    for (int i = 0; i < count_; ++i) {
      loop.push_back(i);
      for (const std::size_t end : {0U, 1U})
        if (ends_[end].side == i)
          loop.push_back(vertex(end));
    }
    return loop;
  }

 private:
  int count_;
  const std::array<ChordEnd, 2>& ends_;
};

// Returns the exact area of a clockwise outline.
Fraction exact_area(const Polygon& outline) {
  BinaryUnit unit;
  for (const Vec2& corner : outline)
    unit.see(corner);
  const Integer x0 = unit(outline[0].x()), y0 = unit(outline[0].y());
  // Corner and corner before, from the first corner. The loop does not allocate.
  Integer twice, x, y, x_before, y_before;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    unit.set(x, outline[i].x());
    unit.set(y, outline[i].y());
    mpz_sub(x.mpz(), x.mpz(), x0.mpz());
    mpz_sub(y.mpz(), y.mpz(), y0.mpz());
    mpz_addmul(twice.mpz(), x.mpz(), y_before.mpz());
    mpz_submul(twice.mpz(), y.mpz(), x_before.mpz());
    std::swap(x, x_before);
    std::swap(y, y_before);
  }
  Fraction area = unit.times_unit(twice, 2);
  area.den *= 2;
  return area;
}

// Rounding keeps the order, so that different doubles decide.
bool is_less(const Fraction& area, double rounded, double min_area) {
  if (rounded != min_area || !std::isfinite(min_area))
    return rounded < min_area;
  return area < Fraction(Rational(min_area));
}

}  // namespace

Split split_outline(const Polygon& outline, const SplitLine& line, double min_area) {
  const RoundToNearest mode;
  Split split;
  split.fault = SplitFault::no_chord;
  if (!is_usable(outline, line))
    return split;
  const auto chord = exact::nearest_chord(exact::meets_of_line(outline, line));
  if (!chord)
    return split;
  const EndMaker maker(outline, line.near);
  split.ends = {maker.end(chord->first), maker.end(chord->second)};
  split.fault = SplitFault::unsound;
  const Loops loops(outline, split.ends);
  if (loops.vertex(0) == loops.vertex(1)) {
    split.certificate.fault = "both ends of the chord move to corner " +
                              std::to_string(split.ends[0].corner + 1);
    return split;
  }
  const std::array<PieceLoop, 2> pieces = {loops.piece(0, 1), loops.piece(1, 0)};
  Mesh mesh;
  mesh.vertices = outline;
  for (const ChordEnd& end : split.ends)
    mesh.vertices.push_back(end.place);
  mesh.cells = {pieces[0].vertices, pieces[1].vertices};
  mesh.outline = loops.outline();
  split.certificate = certify_tiling(mesh);
  for (const ChordEnd& end : split.ends)
    if (!is_on_side(end, outline)) {
      split.certificate.holds = false;
      split.certificate.fault =
          "the new corner on side " + std::to_string(end.side + 1) + " is outside";
    }
  if (!split.certificate.holds)
    return split;
  split.fault = SplitFault::none;
  for (const std::size_t k : {0U, 1U}) {
    SplitPiece& piece = split.pieces[k];
    piece.side = pieces[k].sides;
    for (const int v : pieces[k].vertices) {
      piece.outline.push_back(mesh.vertices[index(v)]);
      piece.corner.push_back(index(v) < outline.size() ? v : -1);
    }
    const Fraction area = exact_area(piece.outline);
    piece.area = exact::rounded_towards(area, 0);
    if (is_less(area, piece.area, min_area))
      split.fault = SplitFault::small;
  }
  return split;
}

}  // namespace blocks::geometry
