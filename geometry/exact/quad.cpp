#include "geometry/exact/quad.hpp"

#include <cstdint>
#include <utility>

namespace blocks::geometry::exact {
namespace {

constexpr std::uint32_t use_width = 0;  // purpose of a random number
constexpr std::uint32_t use_angle = 1;
constexpr std::uint32_t redraws = 16;  // docs/departures.md#orient

Rational two_to_53() { return Rational(std::uint64_t{1} << 53U); }

// Places sides one by one, the middle one first. Each must fit between the nearest
// sides already placed on its left and right. In this order a side that does not fit at
// an end of the layer does not displace all sides along the layer.
class Placer {
 public:
  Placer(const Quad& quad, const std::vector<Rational>& places,
         const std::vector<std::size_t>& numbers, const Rational& angle_min,
         const Rational& angle_max, StreamKey stream)
      : quad_(quad), finder_(quad), places_(places), numbers_(numbers),
        angle_min_(angle_min), angle_part_((angle_max - angle_min) / two_to_53()),
        stream_(stream) {
    result_.sides.resize(places.size());
    result_.sides.front() = {Fraction(0, 1), Fraction(0, 1)};
    result_.sides.back() = {Fraction(1, 1), Fraction(1, 1)};
    same_angle_ = tangent_of_degrees(angle_min_);
  }

  std::optional<OrientedSides> run() {
    if (!place_between(0, places_.size() - 1))
      return std::nullopt;
    return std::move(result_);
  }

 private:
  bool place_between(std::size_t left, std::size_t right) {
    if (right - left < 2)
      return true;
    const std::size_t here = left + (right - left) / 2;
    const auto side = place(here, result_.sides[left], result_.sides[right]);
    if (!side)
      return false;
    result_.sides[here] = *side;
    return place_between(left, here) && place_between(here, right);
  }

  std::optional<Side> place(std::size_t here, const Side& left, const Side& right) {
    const bool one_angle = angle_part_ == 0;
    for (std::uint32_t draw = 0; draw <= redraws; ++draw) {
      const double tangent = one_angle ? same_angle_ : drawn_tangent(here, draw);
      const auto side = finder_.through(places_[here], tangent);
      if (side && left_of(left, *side) && left_of(*side, right))
        return *side;
      if (one_angle)
        break;
      if (draw == 0)
        ++result_.redrawn_sides;
      if (draw < redraws)
        ++result_.redrawn;
    }
    ++result_.ruled;
    return ruling(places_[here], left, right);
  }

  double drawn_tangent(std::size_t here, std::uint32_t draw) const {
    const std::uint64_t bits = random_53_bits(stream_, numbers_[here], draw, use_angle);
    return tangent_of_degrees(angle_min_ + angle_part_ * Rational(bits));
  }

  // Returns the line of the pencil spanned by the two neighbours. It passes through
  // their intersection outside the layer, or is parallel to both, so it cannot cross
  // either. Its tangent is rounded to a double; otherwise numbers would grow from
  // ruling to ruling.
  std::optional<Side> ruling(const Rational& s, const Side& left,
                             const Side& right) const {
    const Point start = quad_.bl + quad_.bottom() * left.bottom.reduced();
    const Point other = quad_.bl + quad_.bottom() * right.bottom.reduced();
    const Vector along = quad_.tl + quad_.top() * left.top.reduced() - start;
    const Vector across = quad_.tl + quad_.top() * right.top.reduced() - other;
    const Rational turn = cross(along, across);
    const Point here = quad_.middle(s);
    const Vector direction =
        turn == 0 ? along
                  : here - (start + along * (cross(other - start, across) / turn));
    const Vector mid = quad_.middle();
    const Rational tangent = -(direction * mid) / cross(mid, direction);
    const auto side = finder_.through(s, nearest(tangent));
    if (side && left_of(left, *side) && left_of(*side, right))
      return side;
    return std::nullopt;
  }

  const Quad& quad_;
  SideFinder finder_;
  const std::vector<Rational>& places_;
  const std::vector<std::size_t>& numbers_;
  Rational angle_min_;
  Rational angle_part_;  ///< 2^-53 of the range of angles
  StreamKey stream_;
  double same_angle_ = 0.0;
  OrientedSides result_;
};

}  // namespace

Rational Quad::length_to_height() const {
  const Rational area = (cross(tr - bl, br - tl)) / Rational(-2);
  return middle().squared_length() / area;
}

SideFinder::SideFinder(const Quad& quad) {
  const Vector mid = quad.middle();
  const Vector normal(-mid.y(), mid.x());
  const Vector half = (quad.tl - quad.bl) / Rational(2);  // M - BL, and TL - M
  const Rational squared = mid.squared_length();
  const Rational start_normal = cross(half, normal);
  const Rational start_middle = cross(half, mid);
  const auto products = [&](const Vector& along) {
    return std::pair(cross(along, normal), cross(along, mid));
  };
  const auto [bottom_normal, bottom_middle] = products(quad.bottom());
  const auto [top_normal, top_middle] = products(quad.top());
  const Integer unit =
      common_denominator({squared, start_normal, start_middle, bottom_normal,
                          bottom_middle, top_normal, top_middle});
  squared_middle_ = times(squared, unit);
  bottom_ = {times(start_normal, unit), times(start_middle, unit),
             times(bottom_normal, unit), times(bottom_middle, unit)};
  top_ = {-bottom_.start_normal, -bottom_.start_middle, times(top_normal, unit),
          times(top_middle, unit)};
}

std::optional<Fraction> SideFinder::meet(const Line& line, const Fraction& s,
                                         const Fraction& tangent) const {
  const Integer& t = tangent.num;
  const Integer& one = tangent.den;
  const Integer turn = line.along_normal * one - line.along_middle * t;
  if (turn == 0)
    return std::nullopt;
  const Integer start = line.start_normal * one - line.start_middle * t;
  return Fraction(s.num * (squared_middle_ * one) + s.den * start, s.den * turn);
}

std::optional<Side> SideFinder::through(const Rational& s, double tangent) const {
  const Fraction place(s);
  const Fraction slope{Rational(tangent)};
  auto bottom = meet(bottom_, place, slope);
  auto top = meet(top_, place, slope);
  if (!bottom || !top)
    return std::nullopt;
  return Side{std::move(*bottom), std::move(*top)};
}

std::optional<OrientedSides> orient_sides(const Quad& quad,
                                          const std::vector<Rational>& places,
                                          const std::vector<std::size_t>& numbers,
                                          const Rational& angle_min,
                                          const Rational& angle_max, StreamKey stream) {
  return Placer(quad, places, numbers, angle_min, angle_max, stream).run();
}

Rational min_width_to_height() { return Rational(1, 5); }
Rational greatest_width_to_height() { return Rational(3); }

std::vector<Rational> random_places(int count, const Rational& length_to_height,
                                    StreamKey stream) {
  const Rational low = min_width_to_height() / length_to_height;
  const Rational high = greatest_width_to_height() / length_to_height;
  // The running sums are integers, so the rationals stay short. A width is low + (high
  // - low) u with u = k / 2^53.
  std::vector<Rational> sum = {Rational(0)};
  for (int block = 1; block <= count; ++block) {
    const auto number = static_cast<std::uint64_t>(block);
    sum.push_back(sum.back() + Rational(random_53_bits(stream, number, 0, use_width)));
  }
  const Rational n(count);
  const Rational full = n * two_to_53();  // all widths at the upper limit
  const bool too_wide = n * low + (high - low) * sum.back() / two_to_53() > 1;
  // Each block has the lower (or upper) limit plus (or minus) its share of the length
  // that is left (or exceeded).
  const Rational limit = too_wide ? low : high;
  const Rational share = too_wide ? (Rational(1) - n * low) / sum.back()
                                  : (Rational(1) - n * high) / (full - sum.back());
  std::vector<Rational> places;
  places.reserve(sum.size());
  for (int j = 0; j <= count; ++j) {
    const Rational blocks(j);
    const Rational& part = sum[static_cast<std::size_t>(j)];
    places.push_back(blocks * limit +
                     share * (too_wide ? part : blocks * two_to_53() - part));
  }
  return places;
}

}  // namespace blocks::geometry::exact
