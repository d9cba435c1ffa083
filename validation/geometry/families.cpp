#include "validation/geometry/families.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace blocks::validation {
namespace {

using geometry::Decimal;
using geometry::DecimalPoint;
using geometry::LayerRequest;
using geometry::Spacing;
using Whole = std::int64_t;

Decimal decimal(Whole digits, int exponent = 0) {
  const auto value =
      Decimal::parse(std::to_string(digits) + "e" + std::to_string(exponent));
  if (!value)
    throw std::logic_error("a family left the range of decimals");
  return *value;
}

// The random numbers of one layer. The modulus favours small results by less than 1e-6.
class Draw {
 public:
  Draw(std::uint64_t family, std::uint64_t number) : key_{family, number} {}
  /// low <= result <= high
  Whole whole(Whole low, Whole high) {
    const std::uint64_t bits = geometry::random_53_bits(key_, next_++, 0, 7);
    return low + static_cast<Whole>(bits % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(Whole n) { return whole(1, n) == 1; }

 private:
  geometry::StreamKey key_;
  std::uint64_t next_ = 0;
};

// A trapezoid with inclined ends, in a frame of whole numbers.
struct Shape {
  Whole length = 0;
  Whole left = 0;  // heights of the two ends
  Whole right = 0;
  Whole lean_left = 0;  // offsets to the right of the tops of the ends
  Whole lean_right = 0;
  Whole along_x = 1;  // direction of the bottom line
  Whole along_y = 0;
  Whole offset_x = 0;
  Whole offset_y = 0;
  int exponent = 0;  // one unit of the frame is 10^exponent
};

std::array<DecimalPoint, 4> corners(const Shape& s) {
  const auto at = [&s](Whole u, Whole v) {
    return DecimalPoint{
        decimal(s.offset_x + u * s.along_x - v * s.along_y, s.exponent),
        decimal(s.offset_y + u * s.along_y + v * s.along_x, s.exponent)};
  };
  return {at(0, 0), at(s.lean_left, s.left), at(s.length + s.lean_right, s.right),
          at(s.length, 0)};
}

void turn(Shape& shape, Draw& draw) {
  do {
    shape.along_x = draw.whole(-100, 100);
    shape.along_y = draw.whole(-100, 100);
  } while (shape.along_x == 0 && shape.along_y == 0);
}

// Makes a rectangle with a height of 0.4 to 4 and a length of 12 to 60 heights. One
// unit is a thousandth.
Shape plain_shape(Draw& draw) {
  Shape s;
  s.exponent = -3;
  s.left = s.right = draw.whole(400, 4000);
  s.length = s.left * draw.whole(12, 60) + draw.whole(0, 999);
  return s;
}

void lean(Shape& shape, Draw& draw) {
  shape.lean_left = draw.whole(-shape.left / 2, shape.left / 2);
  shape.lean_right = draw.whole(-shape.right / 2, shape.right / 2);
}

void angles(LayerRequest& request, Draw& draw, Whole millidegrees) {
  const Whole a = draw.whole(-millidegrees, millidegrees);
  const Whole b = draw.whole(-millidegrees, millidegrees);
  request.angle_min = decimal(std::min(a, b), -3);
  request.angle_max = decimal(std::max(a, b), -3);
}

// Makes a layer of random spacing with a mean width/height between 0.3 and 2.
LayerRequest random_layer(const Shape& shape, Draw& draw) {
  LayerRequest request;
  request.corners = corners(shape);
  request.spacing = Spacing::random;
  const Whole hundredths = draw.whole(30, 200);
  request.count = static_cast<int>(std::max<Whole>(
      1, 200 * (shape.length / hundredths) / (shape.left + shape.right)));
  request.stream = {static_cast<std::uint64_t>(draw.whole(0, 1000000)),
                    static_cast<std::uint64_t>(draw.whole(0, 1000))};
  return request;
}

LayerRequest ordinary(std::uint64_t number) {
  Draw draw(1, number);
  LayerRequest request = random_layer(plain_shape(draw), draw);
  if (draw.one_in(2))
    angles(request, draw, 15000);
  return request;
}

Shape slanted_shape(Draw& draw) {
  Shape s = plain_shape(draw);
  s.right = draw.whole(s.left / 2, s.left * 3 / 2);
  lean(s, draw);
  turn(s, draw);
  s.exponent = -5;
  s.offset_x = draw.whole(-10000000, 10000000);
  s.offset_y = draw.whole(-10000000, 10000000);
  return s;
}

LayerRequest slanted(std::uint64_t number) {
  Draw draw(2, number);
  LayerRequest request = random_layer(slanted_shape(draw), draw);
  angles(request, draw, 20000);
  return request;
}

LayerRequest steep(std::uint64_t number) {
  Draw draw(3, number);
  const bool straight = draw.one_in(2);
  LayerRequest request =
      random_layer(straight ? plain_shape(draw) : slanted_shape(draw), draw);
  request.angle_min = decimal(-draw.whole(40000, 79999), -3);
  request.angle_max = decimal(draw.whole(40000, 79999), -3);
  return request;
}

// Makes a layer 1e-12 high, near the origin or about 1 away from it.
LayerRequest sliver(std::uint64_t number) {
  Draw draw(4, number);
  Shape s;
  s.exponent = -14;
  s.left = s.right = draw.whole(50, 500);
  if (draw.one_in(2)) {
    s.length = s.left * draw.whole(12, 60);
    if (draw.one_in(2))
      turn(s, draw);
    LayerRequest request = random_layer(s, draw);
    angles(request, draw, 20000);
    return request;
  }
  s.length = draw.whole(50000000000000, 200000000000000);  // 0.5 to 2 long
  if (draw.one_in(2))
    s.offset_x = 100000000000000;
  LayerRequest request;
  request.corners = corners(s);
  request.count = static_cast<int>(draw.whole(1, 60));
  return request;
}

LayerRequest scaled(std::uint64_t number) {
  Draw draw(5, number);
  Shape s = slanted_shape(draw);
  s.exponent = static_cast<int>(draw.whole(-17, 7));
  LayerRequest request = random_layer(s, draw);
  angles(request, draw, 45000);
  return request;
}

LayerRequest offset(std::uint64_t number) {
  Draw draw(6, number);
  Shape s = plain_shape(draw);
  if (draw.one_in(2)) {
    lean(s, draw);
    s.right = draw.whole(s.left / 2, s.left * 3 / 2);
    s.along_x = draw.whole(1, 9);
    s.along_y = draw.whole(-9, 9);
  }
  Whole far = 1000000;  // 1e3 to 1e15 in thousandths
  for (Whole decade = draw.whole(0, 12); decade > 0; --decade)
    far *= 10;
  s.offset_x = draw.one_in(2) ? far : -far;
  s.offset_y = draw.one_in(2) ? far : -far / 3;
  LayerRequest request = random_layer(s, draw);
  angles(request, draw, 30000);
  return request;
}

// Makes a layer with one end almost closed: down to 1e-9 of the other.
LayerRequest wedge(std::uint64_t number) {
  Draw draw(7, number);
  Shape s;
  s.exponent = -10;
  s.right = draw.whole(5000000000, 40000000000);
  s.left = s.right;
  for (Whole decade = draw.whole(1, 9); decade > 0; --decade)
    s.left = std::max<Whole>(1, s.left / 10);
  s.length = s.right * draw.whole(6, 30);
  s.lean_left = draw.whole(-s.left / 2, s.left / 2);
  s.lean_right = draw.whole(-s.right / 2, s.right / 2);
  if (draw.one_in(2)) {
    s.along_x = draw.whole(-9, 9);
    s.along_y = draw.whole(1, 9);
  }
  LayerRequest request = random_layer(s, draw);
  angles(request, draw, 60000);
  return request;
}

LayerRequest many(std::uint64_t number) {
  Draw draw(8, number);
  Shape s;
  s.exponent = -3;
  s.left = s.right = draw.whole(500, 2000);
  s.length = 2000 * s.left + draw.whole(0, 999);
  lean(s, draw);
  if (draw.one_in(2)) {
    s.along_x = draw.whole(1, 99);
    s.along_y = draw.whole(-99, 99);
  }
  LayerRequest request = random_layer(s, draw);
  request.count = 2000;
  angles(request, draw, 45000);
  return request;
}

LayerRequest merged(std::uint64_t number) {
  Draw draw(9, number);
  LayerRequest request = random_layer(slanted_shape(draw), draw);
  angles(request, draw, 30000);
  request.merge_ratio = decimal(draw.whole(20, 150), -2);
  return request;
}

// Makes a layer of even spacing, or of listed widths down to 1e-12 of the largest.
LayerRequest listed(std::uint64_t number) {
  Draw draw(10, number);
  LayerRequest request;
  request.corners = corners(draw.one_in(2) ? plain_shape(draw) : slanted_shape(draw));
  request.count = static_cast<int>(draw.whole(1, 40));
  if (draw.one_in(4))
    return request;
  request.spacing = Spacing::listed;
  const int finest = draw.one_in(4) ? 12 : 2;
  for (auto* widths : {&request.bottom, &request.top})
    for (int i = 0; i < request.count; ++i) {
      const Whole digit = draw.whole(1, 9);  // One draw per statement fixes the order.
      widths->push_back(decimal(digit, -static_cast<int>(draw.whole(0, finest))));
    }
  return request;
}

// Makes a quadrilateral that is not a layer: a bow-tie, a dart, reversed or degenerate.
LayerRequest no_layer(std::uint64_t number) {
  Draw draw(11, number);
  Shape s = draw.one_in(2) ? plain_shape(draw) : slanted_shape(draw);
  LayerRequest request = random_layer(s, draw);
  auto& c = request.corners;
  switch (draw.whole(0, 4)) {
  case 0:
    std::swap(c[0], c[1]);  // Two sides cross.
    break;
  case 1:
    std::swap(c[1], c[3]);  // The corners are anticlockwise.
    break;
  case 2:  // One corner is behind the diagonal.
    s.lean_left = s.length * draw.whole(51, 90) / 100;
    s.left = std::max<Whole>(1, s.right / draw.whole(4, 20));
    c = corners(s);
    break;
  case 3:
    c[1] = c[2] =
        c[static_cast<std::size_t>(draw.whole(1, 3))];  // Two corners coincide.
    break;
  default:  // Three corners are collinear: the top left one is on the diagonal.
    s.lean_left = s.length;
    s.left = s.right;
    s.length *= 2;
    s.lean_right = 0;
    s.right *= 2;
    c = corners(s);
    break;
  }
  angles(request, draw, 20000);
  return request;
}

constexpr std::array<Family, 11> all = {{
    {"ordinary", "rectangles, half of them with ORIENT up to 15 degrees", 150, false,
     ordinary},
    {"slanted", "turned trapezoids with leaning ends, ORIENT up to 20", 150, false,
     slanted},
    {"steep", "ORIENT from -79.999 to 79.999 degrees", 120, false, steep},
    {"sliver", "1e-12 high, blocks of that size or up to 2 long", 80, false, sliver},
    {"scaled", "coordinates from 1e-12 to 1e12", 100, false, scaled},
    {"offset", "1e3 to 1e15 away from the origin", 120, false, offset},
    {"wedge", "one end down to 1e-9 of the other, ORIENT up to 60", 80, false, wedge},
    {"many", "2000 blocks", 5, false, many},
    {"merged", "MERGE from 0.2 to 1.5", 65, false, merged},
    {"listed", "even and listed spacing, widths down to 1e-12", 50, false, listed},
    {"no layer", "bow-ties, darts, reversed, repeated, three on a line", 80, true,
     no_layer},
}};

}  // namespace

std::span<const Family> families() { return all; }

}  // namespace blocks::validation
