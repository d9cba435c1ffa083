#include "audit/convex_shapes.hpp"

#include <algorithm>

namespace blocks::audit {
namespace {

int size(const Shape& shape) { return static_cast<int>(shape.size()); }

/// Returns the part of a side in a shape if it has a length.
std::optional<Chord> segment(const Line& side, const Shape& shape) {
  std::optional<Chord> found = chord(side, shape);
  if (!found)
    return found;
  found->begin = std::max(found->begin, Ratio{0});
  found->end = std::min(found->end, Ratio{1});
  return found->begin < found->end ? found : std::nullopt;
}

}  // namespace

Line side_of(const Shape& shape, int index) {
  const auto i = static_cast<std::size_t>(index);
  return {shape[i], shape[i + 1 < shape.size() ? i + 1 : 0] - shape[i]};
}

Shape refined(const Shape& shape, const Whole& factor, const Point& shift) {
  Shape found;
  for (const Point& p : shape)
    found.push_back(factor * p + shift);
  return found;
}

Length deepest(const Line& line, const Shape& shape) {
  Whole max = line.area2(shape.front());
  for (const Point& p : shape)
    max = std::max(max, line.area2(p));
  return {max, line.length2()};
}

Length separating_shift(const Shape& one, const Shape& other) {
  Length min = deepest(side_of(one, 0), other);
  for (int i = 1; i < size(one); ++i)
    min = std::min(min, deepest(side_of(one, i), other));
  for (int i = 0; i < size(other); ++i)
    min = std::min(min, deepest(side_of(other, i), one));
  return min;
}

Length longest_side(const Shape& shape) {
  Length longest = side_of(shape, 0).length();
  for (int i = 1; i < size(shape); ++i)
    longest = std::max(longest, side_of(shape, i).length());
  return longest;
}

std::optional<Chord> chord(const Line& line, const Shape& shape) {
  std::optional<Ratio> begin, end;
  for (int i = 0; i < size(shape); ++i) {
    const Line border = side_of(shape, i);
    const Whole inside = border.area2(line.start),
                gain = cross(line.along, border.along);
    if (sign(gain) == 0) {
      if (sign(inside) < 0)
        return std::nullopt;
      continue;
    }
    if (sign(gain) > 0)
      begin = begin ? std::max(*begin, Ratio{-inside, gain}) : Ratio{-inside, gain};
    else
      end = end ? std::min(*end, Ratio{inside, -gain}) : Ratio{inside, -gain};
  }
  return *begin <= *end ? std::optional<Chord>({*begin, *end}) : std::nullopt;
}

bool crosses(const Line& side, const Shape& shape) {
  return segment(side, shape).has_value();
}

Length common_diameter(const Shape& one, const Shape& other) {
  struct Vertex {
    Point fine;  ///< in a lattice that is finer by the factor
    Whole factor;
  };
  std::vector<Vertex> vertices;
  for (const auto& [shape, in] : {std::pair(&one, &other), std::pair(&other, &one)})
    for (int i = 0; i < size(*shape); ++i) {
      const Line side = side_of(*shape, i);
      if (const std::optional<Chord> part = segment(side, *in))
        for (const Ratio& at : {part->begin, part->end})
          vertices.push_back({at.d * side.start + at.n * side.along, at.d});
    }
  Length max{0, 1};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Vertex &p = vertices[i], &q = vertices[k];
      const Point apart = p.factor * q.fine - q.factor * p.fine;
      const Whole apart2 = dot(apart, apart), factor = p.factor * q.factor;
      if (sign(apart2) > 0)
        max = std::max(max, Length{apart2, apart2} / factor);
    }
  return max;
}

Ratio way_out(const Shape& moving, const Point& way, const Shape& resting) {
  std::optional<Ratio> min;
  // `loss` is what a side loses of its area2 by the vector `way`.
  const auto leave = [&](const Line& side, const Shape& shape, const Whole& loss) {
    if (sign(loss) <= 0)
      return;
    const Ratio at{deepest(side, shape).n, loss};
    min = min ? std::min(*min, at) : at;
  };
  for (int i = 0; i < size(resting); ++i)
    leave(side_of(resting, i), moving, cross(side_of(resting, i).along, way));
  for (int i = 0; i < size(moving); ++i)
    leave(side_of(moving, i), resting, cross(way, side_of(moving, i).along));
  return *min;
}

}  // namespace blocks::audit
