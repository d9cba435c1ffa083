#include "geometry/overlap.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include "geometry/convex_parts.hpp"
#include "geometry/exact/box_pairs.hpp"
#include "geometry/exact/common_part.hpp"
#include "geometry/exact/kernels.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

using exact::Filtered;

struct Box {
  Vec2 low;
  Vec2 high;
};

Box box_of(const Polygon& p) {
  Box box{p.front(), p.front()};
  for (const Vec2& corner : p) {
    box.low = box.low.cwiseMin(corner);
    box.high = box.high.cwiseMax(corner);
  }
  return box;
}

// Boxes that only touch have no common interior.
bool overlap(const Box& a, const Box& b) {
  return (a.low.array() < b.high.array()).all() &&
         (b.low.array() < a.high.array()).all();
}

CGAL::Orientation turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return CGAL::orientation(exact::point(a), exact::point(b), exact::point(c));
}

// Tests whether some edge of the convex clockwise p has all of q on its outer side or
// on its line. If two convex outlines have disjoint interiors, one of them has such an
// edge.
bool edge_separates(const Polygon& p, const Polygon& q) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2& a = p[i];
    const Vec2& b = p[(i + 1) % p.size()];
    // A common corner is on the line; to prove it would take exact numbers.
    if (std::none_of(q.begin(), q.end(), [&](const Vec2& corner) {
          return corner != a && corner != b && turn(a, b, corner) == CGAL::RIGHT_TURN;
        }))
      return true;
  }
  return false;
}

bool interiors_meet(const Polygon& p, const Polygon& q) {
  return !edge_separates(p, q) && !edge_separates(q, p);
}

// Returns the least distance by which q reaches behind an edge of p.
double min_reach(const Polygon& p, const Polygon& q) {
  double min = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2& a = p[i];
    const Vec2 edge = (p[(i + 1) % p.size()] - a).normalized();
    double reach = 0.0;
    for (const Vec2& corner : q)
      reach = std::max(reach, -cross(edge, corner - a));
    min = std::min(min, reach);
  }
  return min;
}

// The shortest translation that separates two convex outlines is along the normal of
// one of their edges.
double separating_shift(const Polygon& p, const Polygon& q) {
  return std::min(min_reach(p, q), min_reach(q, p));
}

// Returns the convex parts of the outline as polygons.
std::vector<Polygon> convex_pieces(const Polygon& outline) {
  std::vector<Polygon> pieces;
  for (const std::vector<int>& part : convex_parts(outline)) {
    Polygon& piece = pieces.emplace_back();
    for (const int corner : part)
      piece.push_back(outline[static_cast<std::size_t>(corner)]);
  }
  return pieces;
}

// Returns the part of the convex q inside the convex clockwise p (Sutherland-Hodgman),
// in doubles and relative to `origin`. Only values of the report use it.
Polygon clipped(const Polygon& p, const Polygon& q, const Vec2& origin) {
  Polygon rest = q;
  for (Vec2& corner : rest)
    corner -= origin;
  for (std::size_t i = 0; i < p.size() && !rest.empty(); ++i) {
    const Vec2 a = p[i] - origin;
    const Vec2 edge = p[(i + 1) % p.size()] - p[i];
    const auto depth = [&](const Vec2& corner) { return -cross(edge, corner - a); };
    Polygon inside;
    for (std::size_t k = 0; k < rest.size(); ++k) {
      const Vec2& here = rest[k];
      const Vec2& then = rest[(k + 1) % rest.size()];
      const double d = depth(here);
      const double e = depth(then);
      if (d >= 0.0)
        inside.push_back(here);
      if ((d > 0.0 && e < 0.0) || (d < 0.0 && e > 0.0)) {
        inside.emplace_back(here + (then - here) * (d / (d - e)));
      }
    }
    rest = std::move(inside);
  }
  return rest;
}

// Returns the intersection of p and q, relative to `origin`. It is computed exactly if
// it is so thin that doubles would leave it few digits or clip it to nothing.
exact::CommonPart common_part(const Polygon& p, const Polygon& q, const Vec2& origin,
                              Figures figures) {
  const Polygon common = clipped(p, q, origin);
  const SectionProperties properties = section_properties(common);
  double size = 0.0;
  for (const Polygon* outline : {&p, &q})
    for (const Vec2& corner : *outline)
      size = std::max(size, (corner - origin).lpNorm<Eigen::Infinity>());
  if (properties.area > 1e-8 * size * size)
    return {properties.area, properties.centroid, separating_shift(p, q)};
  if (figures == Figures::quick)  // an overlap of an ulp may clip to nothing
    return {std::max(properties.area, 0.0),
            common.empty() ? Vec2(q.front() - origin) : common[0],
            separating_shift(p, q)};
  exact::CommonPart thin = exact::common_part(p, q);
  thin.place -= origin;
  return thin;
}

// The outlines with their convex parts, which are computed on first use.
class Blocks {
 public:
  Blocks(const std::vector<Polygon>& outlines, Figures figures)
      : outlines_(outlines), figures_(figures),
        state_(outlines.size(), State::unknown) {}

  std::span<const Polygon> pieces(std::size_t block) {
    const Polygon& outline = outlines_[block];
    if (state_[block] == State::unknown) {
      const OutlineCheck check = check_outline(outline);
      const bool is_whole =
          check.fault == OutlineFault::none && check.convex && !check.anticlockwise;
      state_[block] = is_whole ? State::whole : State::cut;
      if (!is_whole)
        pieces_.emplace(block, convex_pieces(outline));
    }
    if (state_[block] == State::whole)
      return {&outline, 1};
    return pieces_.at(block);
  }

  void compare(std::size_t first, std::size_t second,
               std::vector<BlockOverlap>& found) {
    bool meet = false;
    double area = 0.0, depth = 0.0;
    const Vec2 origin = outlines_[first].front();
    Vec2 moment = Vec2::Zero();
    Vec2 some_place = Vec2::Zero();
    const auto parts = pieces(first), others = pieces(second);
    // The boxes of whole outlines overlap, otherwise they would not be compared.
    const bool are_whole = parts.size() == 1 && others.size() == 1;
    for (const Polygon& p : parts) {
      for (const Polygon& q : others) {
        if (!are_whole && !overlap(box_of(p), box_of(q)))
          continue;
        if (!interiors_meet(p, q))
          continue;
        const exact::CommonPart part = common_part(p, q, origin, figures_);
        if (!meet)
          some_place = part.place;
        meet = true;
        depth = std::max(depth, part.depth);
        area += part.area;
        moment += part.area * part.place;
      }
    }
    if (!meet)
      return;
    const Vec2 place = area > 0.0 ? Vec2(moment / area) : some_place;
    found.push_back({static_cast<int>(first), static_cast<int>(second), area,
                     origin + place, depth});
  }

 private:
  enum class State : char { unknown, whole, cut };

  const std::vector<Polygon>& outlines_;
  Figures figures_;
  std::vector<State> state_;
  std::unordered_map<std::size_t, std::vector<Polygon>> pieces_;  ///< of cut outlines
};

}  // namespace

std::string positive_text(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return value > 0.0 ? text.data() : "less than 5e-324";
}

std::vector<BlockOverlap> overlapping_pairs(const std::vector<Polygon>& outlines,
                                            const std::vector<int>& layer,
                                            Figures figures, StepProgress* progress) {
  struct Enough {};
  Blocks blocks(outlines, figures);
  std::vector<BlockOverlap> found;
  const auto one_tiling = [&](std::size_t first, std::size_t second) {
    return !layer.empty() && layer[first] != 0 && layer[first] == layer[second];
  };
  // Progress is shown by the usual number of close pairs for each block.
  std::size_t pairs = 0;
  const std::size_t max = 5 * outlines.size();
  try {
    exact::for_each_close_pair(
        outlines, {},
        [&](std::size_t first, std::size_t second) {
          if (progress)
            progress->count(++pairs, max);
          if (one_tiling(first, second))
            return;
          blocks.compare(first, second, found);
          if (found.size() == max_overlaps)
            throw Enough{};
        },
        progress);
  } catch (Enough) {
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  return found;
}

}  // namespace blocks::geometry
