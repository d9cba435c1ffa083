#include "validation/geometry/split_judge.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "validation/geometry/exact_judge.hpp"

namespace blocks::validation {
namespace {

using geometry::ChordEnd;
using geometry::Mesh;
using geometry::Polygon;
using geometry::Split;
using geometry::SplitFault;
using geometry::SplitLine;
using geometry::SplitPiece;
using geometry::Vec2;
using Exact = boost::multiprecision::cpp_rational;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Point {
  Exact x, y;
};
Point exactly(const Vec2& v) { return {Exact(v.x()), Exact(v.y())}; }
bool same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }

Exact cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
Exact squared_distance(const Point& a, const Point& b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

std::vector<Point> exactly(const Polygon& outline) {
  std::vector<Point> points;
  for (const Vec2& v : outline)
    points.push_back(exactly(v));
  return points;
}

const Point& next(const std::vector<Point>& p, std::size_t i) {
  return p[(i + 1) % p.size()];
}

bool on_segment(const Point& a, const Point& b, const Point& p) {
  return cross(a, b, p) == 0 && std::min(a.x, b.x) <= p.x &&
         p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool strictly_inside(const std::vector<Point>& p, const Point& q) {
  bool odd = false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = next(p, i);
    if (on_segment(a, b, q))
      return false;
    if ((a.y > q.y) != (b.y > q.y))
      odd ^= (cross(a, b, q) > 0) == (b.y > a.y);
  }
  return odd;
}

// Twice the area, positive if clockwise.
Exact twice_area(const std::vector<Point>& p) {
  Exact sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum += next(p, i).x * p[i].y - p[i].x * next(p, i).y;
  return sum;
}

// An end of the exact chord.
struct End {
  Exact along;  ///< point + along * direction is the place
  Point place;
  std::optional<std::size_t> corner;
  std::size_t side = 0;  ///< otherwise, with the part from its first corner
  Exact part;
};
using Chord = std::array<End, 2>;

// Returns all common points of the line and the outline; of sides that lie in the line,
// the corners.
std::vector<End> common_points(const std::vector<Point>& p, const SplitLine& line) {
  const Point from = exactly(line.point), along = exactly(line.along);
  std::vector<End> ends;
  const auto distance = [&](const Point& q) -> Exact {  // to the left
    return along.x * (q.y - from.y) - along.y * (q.x - from.x);
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = next(p, i);
    const Exact da = distance(a), db = distance(b);
    End end;
    if (da == 0) {
      end.place = a;
      end.corner = i;
    } else if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      end.side = i;
      end.part = da / (da - db);
      end.place = {a.x + (b.x - a.x) * end.part, a.y + (b.y - a.y) * end.part};
    } else {
      continue;
    }
    end.along = along.x != 0 ? Exact((end.place.x - from.x) / along.x)
                             : Exact((end.place.y - from.y) / along.y);
    ends.push_back(end);
  }
  std::sort(ends.begin(), ends.end(),
            [](const End& a, const End& b) { return a.along < b.along; });
  return ends;
}

// Tests the middle of every interval between two common points.
std::optional<Chord> exact_chord(const std::vector<Point>& p, const SplitLine& line) {
  const auto ends = common_points(p, line);
  std::optional<Chord> best;
  Exact min;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const End &a = ends[k - 1], &b = ends[k];
    if (!strictly_inside(p, {(a.place.x + b.place.x) / 2, (a.place.y + b.place.y) / 2}))
      continue;
    const Exact distance =
        a.along > 0 ? a.along : (b.along < 0 ? Exact(-b.along) : Exact(0));
    if (!best || distance < min) {
      best = {a, b};
      min = distance;
    }
  }
  return best;
}

// Is the double one of the two next to the exact value, or equal to it?
bool next_to(double rounded, const Exact& value) {
  const double below = std::nextafter(rounded, -infinity),
               above = std::nextafter(rounded, infinity);
  return (std::isinf(below) || Exact(below) < value) &&
         (std::isinf(above) || value < Exact(above));
}

// Is the double a nearest one? An infinite one is nearest beyond the finite ones.
bool nearest_to(double rounded, const Exact& value) {
  if (std::isinf(rounded))
    return abs(value) > Exact(std::numeric_limits<double>::max());
  const Exact error = abs(Exact(rounded) - value);
  for (const double to : {-infinity, infinity}) {
    const double other = std::nextafter(rounded, to);
    if (!std::isinf(other) && abs(Exact(other) - value) < error)
      return false;
  }
  return true;
}

bool about(double rounded, const Exact& squared) {
  const Exact low = Exact(rounded) * Exact(1 - 1e-14),
              high = Exact(rounded) * Exact(1 + 1e-14);
  return low * low <= squared && squared <= high * high;
}

class SplitJudge {
 public:
  SplitJudge(const Polygon& outline, const SplitLine& line, double min_area,
             const Split& split)
      : outline_(outline), p_(exactly(outline)), line_(line), min_area_(min_area),
        split_(split) {}

  std::string fault() const {
    const auto chord = exact_chord(p_, line_);
    if (chord.has_value() == (split_.fault == SplitFault::no_chord))
      return chord ? "a chord is missed" : "there is no chord";
    if (!chord)
      return {};
    for (const std::size_t k : {0U, 1U})
      if (const auto fault = end_fault((*chord)[k], split_.ends[k]); !fault.empty())
        return "end " + std::to_string(k) + ": " + fault;
    return pieces_fault();
  }

 private:
  std::string end_fault(const End& exact, const ChordEnd& end) const {
    if ((end.corner < 0) == (end.side < 0))
      return "neither a corner nor on a side, or both";
    if (end.corner >= static_cast<int>(p_.size()) ||
        end.side >= static_cast<int>(p_.size()))
      return "there is no such corner or side";
    if (exact.corner)
      return end.corner == static_cast<int>(*exact.corner) && end.moved == 0.0 &&
                     end.part == 0.0 &&
                     end.place == outline_[static_cast<std::size_t>(end.corner)]
                 ? ""
                 : "not the corner of the chord";
    const std::size_t i = exact.side, j = (i + 1) % p_.size();
    const Exact to_first = squared_distance(exact.place, p_[i]),
                to_last = squared_distance(exact.place, p_[j]);
    const bool first = to_first < to_last || (to_first == to_last && i < j);
    const Exact near(line_.near), min = first ? to_first : to_last;
    if (end.corner >= 0)
      return corner_fault(exact, end, first ? i : j, min, min < near * near);
    if (min < near * near)
      return "not moved to the near corner";
    return new_corner_fault(exact, end, i, j);
  }
  std::string corner_fault(const End& exact, const ChordEnd& end, std::size_t corner,
                           const Exact& min, bool near) const {
    const std::size_t moved_to = static_cast<std::size_t>(end.corner);
    if (moved_to != corner || end.place != outline_[corner])
      return "not the near corner";
    if (!about(end.moved, min) || end.part != 0.0)
      return "the distance of the move is wrong";
    // A crossing that is not near a corner may still round to it.
    if (!near && !(nearest_to(end.place.x(), exact.place.x) &&
                   nearest_to(end.place.y(), exact.place.y)))
      return "moved to a corner that is not near";
    return {};
  }
  std::string new_corner_fault(const End& exact, const ChordEnd& end, std::size_t i,
                               std::size_t j) const {
    if (end.side != static_cast<int>(i) || end.moved != 0.0)
      return "not on the side of the crossing";
    if (!next_to(end.place.x(), exact.place.x) ||
        !next_to(end.place.y(), exact.place.y))
      return "not rounded once";
    const Point place = exactly(end.place);
    const Point &a = p_[i], &b = p_[j];
    if (cross(a, b, place) > 0)
      return "rounded outward";
    if ((a.x == b.x || a.y == b.y) &&
        !(cross(a, b, place) == 0 && nearest_to(end.place.x(), exact.place.x) &&
          nearest_to(end.place.y(), exact.place.y)))
      return "not the nearest double on a side along an axis";
    if (place.x < std::min(a.x, b.x) || place.x > std::max(a.x, b.x) ||
        place.y < std::min(a.y, b.y) || place.y > std::max(a.y, b.y) ||
        same(place, a) || same(place, b))
      return "not between the corners of the side";
    if (!nearest_to(end.part, exact.part))
      return "the part is not rounded to the nearest";
    return {};
  }

  // The outline with the new corners; each entry with the side that begins there.
  struct Entry {
    Vec2 place;
    int corner, side;
    int end;  ///< of the chord; -1: none
  };
  std::vector<Entry> entries() const {
    std::vector<Entry> list;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const int number = static_cast<int>(i);
      list.push_back({outline_[i], number, number, -1});
      for (const int k : {0, 1}) {
        const ChordEnd& end = split_.ends[static_cast<std::size_t>(k)];
        if (end.side == number)
          list.push_back({end.place, -1, number, k});
      }
    }
    for (Entry& entry : list)
      for (const int k : {0, 1})
        if (entry.corner >= 0 &&
            split_.ends[static_cast<std::size_t>(k)].corner == entry.corner)
          entry.end = k;
    return list;
  }

  std::string pieces_fault() const {
    const auto list = entries();
    const auto position = [&list](int end) {
      return static_cast<std::size_t>(
          std::find_if(list.begin(), list.end(),
                       [end](const Entry& e) { return e.end == end; }) -
          list.begin());
    };
    const std::size_t at[2] = {position(0), position(1)};
    const bool moved_together = std::max(at[0], at[1]) == list.size();
    Mesh mesh;
    for (const Entry& entry : list) {
      mesh.outline.push_back(static_cast<int>(mesh.vertices.size()));
      mesh.vertices.push_back(entry.place);
    }
    // A mesh of vertices and cells, for the judge of tilings.
    std::array<std::vector<std::size_t>, 2> pieces;
    for (const std::size_t k : {0U, 1U}) {
      if (moved_together)
        break;
      for (std::size_t i = at[k];; i = (i + 1) % list.size()) {
        pieces[k].push_back(i);
        if (i == at[1 - k])
          break;
      }
      mesh.cells.emplace_back(pieces[k].begin(), pieces[k].end());
    }
    const bool tiles = !moved_together && pieces[0].size() > 2 &&
                       pieces[1].size() > 2 && judge(mesh).conforming;
    if (split_.certificate.holds != tiles)
      return tiles ? "refused, but it tiles" : "certified, but it does not tile";
    if (split_.certificate.holds == !split_.certificate.fault.empty())
      return "the certificate contradicts itself";
    if (!tiles)
      return split_.fault == SplitFault::unsound ? "" : "not called unsound";
    return fields_fault(list, pieces);
  }

  std::string
  fields_fault(const std::vector<Entry>& list,
               const std::array<std::vector<std::size_t>, 2>& pieces) const {
    Exact sum = 0;
    bool small = false;
    for (const std::size_t k : {0U, 1U}) {
      const SplitPiece& piece = split_.pieces[k];
      const std::size_t n = pieces[k].size();
      if (piece.outline.size() != n || piece.corner.size() != n ||
          piece.side.size() != n)
        return "a piece has another number of corners";
      // The lowest corner of the old outline comes first.
      std::size_t shift = n;
      for (std::size_t i = 0; i < n; ++i) {
        const int corner = list[pieces[k][i]].corner;
        if (corner >= 0 && (shift == n || corner < list[pieces[k][shift]].corner))
          shift = i;
      }
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t from = (shift + i) % n;
        const Entry& entry = list[pieces[k][from]];
        const int side = from + 1 == n ? -1 : entry.side;
        if (piece.outline[i] != entry.place || piece.corner[i] != entry.corner ||
            piece.side[i] != side)
          return "a corner of a piece is wrong";
      }
      const Exact twice = twice_area(exactly(piece.outline));
      sum += twice;
      small = small || twice < 2 * Exact(min_area_);
      if (!nearest_to(piece.area, twice / 2))
        return "an area is not rounded to the nearest";
    }
    if (small != (split_.fault == SplitFault::small))
      return small ? piece_too_small : "no piece is too small";
    if (!small && split_.fault != SplitFault::none)
      return "refused without a reason";
    Polygon all;
    for (const Entry& entry : list)
      all.push_back(entry.place);
    const Exact whole = twice_area(exactly(all));
    if (sum != whole || whole > twice_area(p_))
      return "the areas do not add up";
    return {};
  }

  const Polygon& outline_;
  const std::vector<Point> p_;
  const SplitLine& line_;
  double min_area_;
  const Split& split_;
};

}  // namespace

std::string judge_split(const Polygon& outline, const SplitLine& line, double min_area,
                        const Split& split) {
  return SplitJudge(outline, line, min_area, split).fault();
}

}  // namespace blocks::validation
