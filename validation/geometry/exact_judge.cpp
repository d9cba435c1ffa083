#include "validation/geometry/exact_judge.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace blocks::validation {
namespace {

using geometry::Mesh;
using geometry::Vec2;
namespace mp = boost::multiprecision;
// Integers of any width; up to 512 bits need no allocation.
using Whole = mp::number<mp::cpp_int_backend<512>, mp::et_off>;

struct Place {
  Whole x, y;
};
using Loop = std::vector<Place>;
using Triangle = std::array<Place, 3>;

bool same(const Place& a, const Place& b) { return a.x == b.x && a.y == b.y; }

// Returns 1 if a, b, c turn left, -1 if they turn right, 0 if they are collinear.
int turn(const Place& a, const Place& b, const Place& c) {
  const Whole d = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return d.sign();
}

// Is c between a and b, or equal to one of them? c must be collinear with a and b.
bool between(const Place& a, const Place& b, const Place& c) {
  return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= c.y && c.y <= std::max(a.y, b.y);
}

bool on_segment(const Place& a, const Place& b, const Place& c) {
  return between(a, b, c) && turn(a, b, c) == 0;
}

bool boxes_apart(const Place& a, const Place& b, const Place& c, const Place& d) {
  return std::max(a.x, b.x) < std::min(c.x, d.x) ||
         std::max(c.x, d.x) < std::min(a.x, b.x) ||
         std::max(a.y, b.y) < std::min(c.y, d.y) ||
         std::max(c.y, d.y) < std::min(a.y, b.y);
}

// Do the closed segments a-b and c-d have a common point?
bool meet(const Place& a, const Place& b, const Place& c, const Place& d) {
  if (boxes_apart(a, b, c, d))
    return false;
  if (on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) ||
      on_segment(c, d, b))
    return true;
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

const Place& next(const Loop& loop, std::size_t i) {
  return loop[(i + 1) % loop.size()];
}

bool simple(const Loop& loop) {
  const std::size_t n = loop.size();
  if (n < 3)
    return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (same(loop[i], next(loop, i)))
      return false;
    for (std::size_t j = i + 1; j < n; ++j) {
      if (j == i + 1 || (i == 0 && j == n - 1)) {  // Neighbours share one corner.
        const std::size_t first = j == i + 1 ? i : j;
        const Place& far = loop[(first + 2) % n];
        if (on_segment(loop[first], next(loop, first), far) ||
            on_segment(next(loop, first), far, loop[first]))
          return false;
      } else if (meet(loop[i], next(loop, i), loop[j], next(loop, j))) {
        return false;
      }
    }
  }
  return true;
}

// Returns twice the area, positive for a clockwise loop.
Whole area(const Loop& loop) {
  Whole sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Place& a = loop[i];
    const Place& b = next(loop, i);
    sum += b.x * a.y - a.x * b.y;
  }
  return sum;
}

bool in_closed(const Triangle& t, const Place& p) {
  return turn(t[0], t[1], p) <= 0 && turn(t[1], t[2], p) <= 0 &&
         turn(t[2], t[0], p) <= 0;
}

// Triangulates a simple clockwise loop by cutting off one ear after another.
std::vector<Triangle> triangles(Loop loop) {
  std::vector<Triangle> result;
  while (loop.size() > 2) {
    const std::size_t n = loop.size();
    std::size_t ear = n;
    for (std::size_t i = 0; i < n && ear == n; ++i) {
      const Triangle t = {loop[i], loop[(i + 1) % n], loop[(i + 2) % n]};
      const int bend = turn(t[0], t[1], t[2]);
      if (bend > 0)
        continue;
      bool free = true;
      for (std::size_t k = 3; k < n && free && bend < 0; ++k)
        free = !in_closed(t, loop[(i + k) % n]);
      if (free) {
        ear = (i + 1) % n;
        if (bend < 0)
          result.push_back(t);
      }
    }
    if (ear == n)
      throw std::logic_error("a simple polygon without an ear");
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return result;
}

// Does all of `other` lie outside one edge of t, or on that edge?
template <class Places> bool beyond_an_edge(const Triangle& t, const Places& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::all_of(other.begin(), other.end(),
                    [&](const Place& p) { return turn(t[i], t[(i + 1) % 3], p) >= 0; }))
      return true;
  }
  return false;
}

bool interiors_meet(const Triangle& a, const Triangle& b) {
  return !beyond_an_edge(a, b) && !beyond_an_edge(b, a);
}

// Does the segment a-b pass through the interior of the triangle?
bool enters(const Triangle& t, const Place& a, const Place& b) {
  if (beyond_an_edge(t, std::array<Place, 2>{a, b}))
    return false;
  int left = 0;
  int right = 0;
  for (const Place& p : t) {
    const int side = turn(a, b, p);
    left += side > 0 ? 1 : 0;
    right += side < 0 ? 1 : 0;
  }
  return left > 0 && right > 0;
}

bool inside(const Loop& loop, const Place& p) {
  bool odd = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Place& a = loop[i];
    const Place& b = next(loop, i);
    if ((a.y > p.y) != (b.y > p.y))
      odd ^= (turn(a, b, p) > 0) == (b.y > a.y);
  }
  return odd;
}

// A bounding box, used to skip pairs that are far apart.
struct Box {
  Place low, high;
};
Box box_of(const Loop& loop) {
  Box box{loop[0], loop[0]};
  for (const Place& p : loop) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool apart(const Box& a, const Box& b) {
  return boxes_apart(a.low, a.high, b.low, b.high);
}

struct Cell {
  Loop loop;
  Box box;
  std::vector<Triangle> parts;
};

bool disjoint(const Cell& a, const Cell& b) {
  if (apart(a.box, b.box))
    return true;
  for (const Triangle& s : a.parts)
    for (const Triangle& t : b.parts)
      if (interiors_meet(s, t))
        return false;
  return true;
}

bool within(const Cell& cell, const Loop& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Place& a = outline[i];
    const Place& b = next(outline, i);
    if (boxes_apart(cell.box.low, cell.box.high, a, b))
      continue;
    for (const Triangle& t : cell.parts)
      if (enters(t, a, b))
        return false;
  }
  for (const Triangle& t : cell.parts) {
    // The coordinates are multiples of 3, so the centroid is a whole number.
    const Place centroid = {(t[0].x + t[1].x + t[2].x) / 3,
                            (t[0].y + t[1].y + t[2].y) / 3};
    if (!inside(outline, centroid))
      return false;
  }
  return true;
}

// Converts doubles to whole numbers: mantissa * 2^(exponent - least) * 3.
class Scale {
 public:
  void see(double x) {
    if (x != 0.0)
      min_ = std::min(min_, std::ilogb(x) - 52);
  }
  Whole operator()(double x) const {
    if (x == 0.0)
      return 0;
    const int exponent = std::ilogb(x) - 52;
    const Whole mantissa(static_cast<long long>(std::ldexp(x, -exponent)));
    return mantissa * 3 * (Whole(1) << static_cast<unsigned>(exponent - min_));
  }
  Place operator()(const Vec2& p) const { return {(*this)(p.x()), (*this)(p.y())}; }

 private:
  int min_ = 2000;
};

std::optional<Loop> loop_of(const std::vector<int>& indices,
                            const std::vector<Place>& places) {
  Loop loop;
  for (const int v : indices) {
    if (v < 0 || static_cast<std::size_t>(v) >= places.size())
      return std::nullopt;
    loop.push_back(places[static_cast<std::size_t>(v)]);
  }
  return loop;
}

bool conforms(const Mesh& mesh, const std::vector<Place>& places) {
  std::vector<bool> used(places.size(), false);
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  const auto add = [&](const std::vector<int>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto from = static_cast<std::size_t>(loop[i]);
      used[from] = true;
      edges.emplace_back(from, static_cast<std::size_t>(loop[(i + 1) % loop.size()]));
    }
  };
  for (const auto& cell : mesh.cells)
    add(cell);
  add(mesh.outline);
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (!used[v])
      continue;
    for (const auto& [from, to] : edges) {
      if (v != from && v != to && on_segment(places[from], places[to], places[v]))
        return false;
    }
  }
  return true;
}

std::string fault_of(const Mesh& mesh, const std::vector<Place>& places) {
  if (mesh.cells.empty())
    return "no cells";
  const auto outline = loop_of(mesh.outline, places);
  if (!outline)
    return "a vertex index points nowhere";
  if (!simple(*outline) || area(*outline) <= 0)
    return "the outline is not simple and clockwise";
  std::vector<Cell> cells;
  Whole total = 0;
  for (const auto& indices : mesh.cells) {
    auto loop = loop_of(indices, places);
    if (!loop)
      return "a vertex index points nowhere";
    const Whole cell_area = area(*loop);
    if (!simple(*loop) || cell_area <= 0)
      return "a cell is not simple and clockwise";
    total += cell_area;
    const Box box = box_of(*loop);
    auto parts = triangles(*loop);
    cells.push_back({std::move(*loop), box, std::move(parts)});
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = i + 1; j < cells.size(); ++j)
      if (!disjoint(cells[i], cells[j]))
        return "two cells overlap";
  for (const Cell& cell : cells)
    if (!within(cell, *outline))
      return "a cell leaves the outline";
  if (total != area(*outline))
    return "a part of the outline is not covered";
  return {};
}

}  // namespace

Judgement judge(const Mesh& mesh) {
  Judgement result;
  Scale scale;
  for (const Vec2& v : mesh.vertices) {
    if (!v.allFinite()) {
      result.reason = "a coordinate is not finite";
      return result;
    }
    scale.see(v.x());
    scale.see(v.y());
  }
  std::vector<Place> places;
  for (const Vec2& v : mesh.vertices)
    places.push_back(scale(v));
  result.reason = fault_of(mesh, places);
  result.tiles = result.reason.empty();
  if (result.tiles) {
    result.conforming = conforms(mesh, places);
    if (!result.conforming)
      result.reason = "a corner lies inside an edge, or two at one place";
  }
  return result;
}

bool within_corners(const Mesh& mesh, const std::array<Vec2, 4>& corners) {
  Scale scale;
  for (const auto* points : {&mesh.vertices})
    for (const Vec2& v : *points) {
      scale.see(v.x());
      scale.see(v.y());
    }
  for (const Vec2& v : corners) {
    scale.see(v.x());
    scale.see(v.y());
  }
  Loop quad;
  for (const Vec2& v : corners)
    quad.push_back(scale(v));
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec2& v) {
    const Place p = scale(v);
    for (std::size_t i = 0; i < 4; ++i)
      if (turn(quad[i], next(quad, i), p) > 0)
        return false;
    return true;
  });
}

}  // namespace blocks::validation
