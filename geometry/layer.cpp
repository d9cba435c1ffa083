#include "geometry/layer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/exact/merge.hpp"
#include "geometry/exact/numbers.hpp"
#include "geometry/exact/quad.hpp"
#include "geometry/exact/rounded_line.hpp"

namespace blocks::geometry {
namespace {

using exact::Fraction;
using exact::Point;
using exact::Quad;
using exact::Rational;
using exact::RoundedLine;
using exact::Side;
using exact::Vector;

constexpr int steepest_angle = 80;  // degrees

LayerError not_for_doubles(const std::string& what) {
  return {LayerError::Kind::shape,
          "rounding the corners to doubles makes a block of the layer invalid: " + what,
          "the layer is too thin, or too far from the origin for its size"};
}

Quad convex_quad(const LayerRequest& request) {
  const auto refuse = [](const std::string& what, const std::string& hint) {
    throw LayerError(LayerError::Kind::shape, what, hint);
  };
  const std::string order = "bottom left, top left, top right, bottom right";
  switch (classify_quad(request.corners)) {
  case QuadShape::convex_clockwise:
    break;
  case QuadShape::convex_anticlockwise:
    refuse("the corners of the layer run anticlockwise", "the order is " + order);
    break;
  case QuadShape::bow_tie:
    refuse("two sides of the layer cross", "the order is " + order);
    break;
  case QuadShape::dart:
    refuse("a corner of the layer points inwards", "a layer has to be convex");
    break;
  case QuadShape::degenerate:
    refuse("three corners of the layer lie on one line",
           "a layer needs four corners, each with an angle below 180 degrees");
    break;
  }
  const auto& c = request.corners;
  return {exact::rational(c[0]), exact::rational(c[1]), exact::rational(c[2]),
          exact::rational(c[3])};
}

// Returns sides at equal fractions of both lines.
std::vector<Side> even_sides(int count) {
  std::vector<Side> sides;
  for (int i = 0; i <= count; ++i) {
    sides.push_back({Fraction(i, count), Fraction(i, count)});
  }
  return sides;
}

// Returns the running sums of listed widths over their total. scaled: set if the total
// differs from the length of the line.
std::vector<Rational> listed_fractions(const std::vector<Decimal>& widths, int count,
                                       const Vector& line, const char* which,
                                       bool& scaled) {
  if (widths.size() != static_cast<std::size_t>(count)) {
    throw LayerError(LayerError::Kind::spacing,
                     std::to_string(widths.size()) + " widths along the " + which +
                         " line of a layer of " + std::to_string(count) + " blocks",
                     "give one width for each block");
  }
  std::vector<Rational> sum = {Rational(0)};
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const Rational width = exact::rational(widths[i]);
    if (width <= 0) {
      throw LayerError(LayerError::Kind::spacing,
                       "width " + std::to_string(i + 1) + " along the " + which +
                           " line is not positive",
                       "widths have to be greater than 0");
    }
    sum.push_back(sum.back() + width);
  }
  const Rational total = sum.back();
  // Most slanted lines have a length that no decimal equals, so nine digits are enough.
  const Rational squares = total * total / line.squared_length();
  scaled = std::abs(exact::nearest(squares - Rational(1))) > 2e-9;
  for (Rational& s : sum)
    s /= total;
  return sum;
}

std::vector<Side> listed_sides(const LayerRequest& request, const Quad& quad,
                               Layer& layer) {
  const auto bottom = listed_fractions(request.bottom, request.count, quad.bottom(),
                                       "bottom", layer.bottom_scaled);
  const auto top =
      listed_fractions(request.top, request.count, quad.top(), "top", layer.top_scaled);
  std::vector<Side> sides;
  for (std::size_t i = 0; i < bottom.size(); ++i)
    sides.push_back({Fraction(bottom[i]), Fraction(top[i])});
  return sides;
}

// Returns the largest integer not above a non-negative rational.
CGAL::Gmpz whole(const Rational& value) {
  return value.numerator() / value.denominator();
}

void check_aspect(int count, const Rational& length_to_height) {
  const Rational n(count);
  const Rational low = exact::min_width_to_height();
  const Rational high = exact::greatest_width_to_height();
  if (n * low <= length_to_height && length_to_height <= n * high)
    return;
  const CGAL::Gmpz max = whole(length_to_height / low);
  CGAL::Gmpz fewest = whole(length_to_height / high);
  if (Rational(fewest) * high < length_to_height)
    fewest += 1;
  const auto text = [](const CGAL::Gmpz& z) {
    std::string digits(mpz_sizeinbase(z.mpz(), 10) + 2, '\0');
    mpz_get_str(digits.data(), 10, z.mpz());
    digits.resize(digits.find('\0'));
    return digits;
  };
  const std::string blocks =
      std::to_string(count) + (count == 1 ? " block" : " blocks");
  throw LayerError(
      LayerError::Kind::aspect,
      "no random widths with 0.2 <= width/height <= 3.0 fit " + blocks +
          " into this layer",
      fewest <= max
          ? "from " + text(fewest) + " to " + text(max) + " blocks are possible"
          : "the layer is too short for its height: no number of blocks is possible");
}

std::vector<Side> random_sides(const LayerRequest& request, const Quad& quad,
                               Layer& layer) {
  const Rational angle_min = exact::rational(request.angle_min);
  const Rational angle_max = exact::rational(request.angle_max);
  if (angle_min > angle_max || angle_min < -steepest_angle ||
      angle_max > steepest_angle) {
    throw LayerError(LayerError::Kind::angle,
                     "the angles of the block sides are out of range",
                     "-80 <= angmin <= angplus <= 80 degrees");
  }
  const Rational length_to_height = quad.length_to_height();
  check_aspect(request.count, length_to_height);
  const std::vector<Rational> drawn =
      exact::random_places(request.count, length_to_height, request.stream);
  std::vector<std::size_t> kept(drawn.size());
  std::iota(kept.begin(), kept.end(), 0U);
  if (request.merge_ratio) {
    kept =
        exact::merge_slender(drawn, length_to_height,
                             exact::rational(*request.merge_ratio), layer.absorptions);
  }
  std::vector<Rational> places;
  for (const std::size_t i : kept)
    places.push_back(drawn[i]);
  auto oriented =
      exact::orient_sides(quad, places, kept, angle_min, angle_max, request.stream);
  if (!oriented)
    throw not_for_doubles("two sides are too close to each other");
  layer.redrawn = oriented->redrawn;
  layer.redrawn_sides = oriented->redrawn_sides;
  layer.ruled = oriented->ruled;
  return std::move(oriented->sides);
}

// Builds the mesh of a layer. Its vertices are the bottom ends of the sides from the
// left, then their top ends.
Mesh mesh_of(const Quad& quad, const std::array<Vec2, 4>& corners,
             const std::vector<Side>& sides) {
  const std::size_t n = sides.size() - 1;
  Mesh mesh;
  mesh.vertices.resize(2 * (n + 1));
  // The top line runs from right to left, so that it has the layer on its left as well.
  const RoundedLine bottom_line(quad.bl, quad.br, corners[0], corners[3]);
  const RoundedLine top_line(quad.tr, quad.tl, corners[2], corners[1]);
  for (std::size_t i = 0; i <= n; ++i) {
    const Fraction& s = sides[i].top;
    mesh.vertices[i] = bottom_line.at(sides[i].bottom);
    mesh.vertices[n + 1 + i] = top_line.at({s.den - s.num, s.den});
  }
  const auto bottom = [](std::size_t i) { return static_cast<int>(i); };
  const auto top = [n](std::size_t i) { return static_cast<int>(n + 1 + i); };
  for (std::size_t i = 0; i < n; ++i) {
    mesh.cells.push_back({bottom(i), top(i), top(i + 1), bottom(i + 1)});
  }
  mesh.outline.push_back(bottom(0));
  for (std::size_t i = 0; i <= n; ++i)
    mesh.outline.push_back(top(i));
  for (std::size_t i = n; i > 0; --i)
    mesh.outline.push_back(bottom(i));
  return mesh;
}

}  // namespace

QuadShape classify_quad(const std::array<DecimalPoint, 4>& corners) {
  std::array<Point, 4> p;
  for (std::size_t i = 0; i < 4; ++i)
    p[i] = exact::rational(corners[i]);
  int left = 0;
  int right = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto turn = CGAL::orientation(p[i], p[(i + 1) % 4], p[(i + 2) % 4]);
    left += turn == CGAL::LEFT_TURN ? 1 : 0;
    right += turn == CGAL::RIGHT_TURN ? 1 : 0;
  }
  if (left + right < 4)
    return QuadShape::degenerate;
  if (right == 4)
    return QuadShape::convex_clockwise;
  if (left == 4)
    return QuadShape::convex_anticlockwise;
  return left == 2 ? QuadShape::bow_tie : QuadShape::dart;
}

std::uint64_t stream_of(const LayerRequest& request) {
  std::uint64_t key = static_cast<std::uint64_t>(request.count);
  const auto add = [&key](double value) {
    key += std::bit_cast<std::uint64_t>(value + 0.0) + 0x9E3779B97F4A7C15ULL;
    key = (key ^ (key >> 30)) * 0xBF58476D1CE4E5B9ULL;  // splitmix64
    key = (key ^ (key >> 27)) * 0x94D049BB133111EBULL;
    key ^= key >> 31;
  };
  for (const DecimalPoint& corner : request.corners) {
    add(corner.x.value());
    add(corner.y.value());
  }
  return key;
}

Layer cut_layer(const LayerRequest& request) {
  if (request.count < 1) {
    throw LayerError(LayerError::Kind::spacing, "a layer needs at least one block",
                     "give 1 or more");
  }
  const Quad quad = convex_quad(request);
  Layer layer;
  std::vector<Side> sides;
  switch (request.spacing) {
  case Spacing::even:
    sides = even_sides(request.count);
    break;
  case Spacing::listed:
    sides = listed_sides(request, quad, layer);
    break;
  case Spacing::random:
    sides = random_sides(request, quad, layer);
    break;
  }
  const std::array<Vec2, 4> corners = request.rounded.value_or(
      std::array{exact::nearest(quad.bl), exact::nearest(quad.tl),
                 exact::nearest(quad.tr), exact::nearest(quad.br)});
  layer.mesh = mesh_of(quad, corners, sides);
  layer.certificate = certify_tiling(layer.mesh);
  if (!layer.certificate.holds) {
    throw not_for_doubles(layer.certificate.fault);
  }
  return layer;
}

}  // namespace blocks::geometry
