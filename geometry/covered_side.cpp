// The quick test in doubles: most sides are certainly not covered.
#include "geometry/covered_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks::geometry {
namespace {

const Vec2& start_of(Outline polygon, std::size_t side) { return polygon[side]; }
const Vec2& end_of(Outline polygon, std::size_t side) {
  return polygon[side + 1 < polygon.size() ? side + 1 : 0];
}

/// Bounds of a number.
struct Range {
  double low, high;
};

/// The part of a side that is behind several lines, in [0, 1] along the side. Each line
/// cuts it by the depths of the side's two ends below that line. Depths may have an
/// error of `error`.
struct PartBehind {
  Range from = {0.0, 0.0}, to = {1.0, 1.0};

  void cut(double first, double last, double error) {
    const auto zero = [](double a, double b) { return a / (a - b); };
    const double first_low = first - error, first_high = first + error;
    const double last_low = last - error, last_high = last + error;
    if (first_low > 0.0 && last_low < 0.0)
      to.low = std::min(to.low, zero(first_low, last_low));
    if (first_high > 0.0 && last_high < 0.0)
      to.high = std::min(to.high, zero(first_high, last_high));
    if (first_low < 0.0 && last_low > 0.0)
      from.high = std::max(from.high, zero(first_low, last_low));
    if (first_high < 0.0 && last_high > 0.0)
      from.low = std::max(from.low, zero(first_high, last_high));
    if (first_low <= 0.0 && last_low <= 0.0)
      from.high = 1.0, to.low = 0.0;
    if (first_high < 0.0 && last_high < 0.0)
      from.low = 1.0, to.high = 0.0;
  }
};

/// If lengths are between `smallest` and `largest`, [L], no product of two overflows,
/// and what underflow loses is less than `lost`.
constexpr double smallest = 1e-140, largest = 1e140, lost = 1e-150;

/// Returns the error bound of a point's position across or along a side. The point is
/// `distance` away from an end of the side and moves against it by `of_point`. `turn`
/// bounds the rotation of the side (turn_of); it is infinite if the side may rotate by
/// any angle. Unit vectors along a and b differ by at most |a - b| / sqrt(|a| |b|).
/// Rounding errors are below 1e-15 distance.
double error_of(double distance, double of_point, double turn) {
  return (1.0 + 1e-9) * (of_point + (distance + of_point) * turn) + 1e-12 * distance +
         lost;
}
/// Bounds the rotation of a side whose ends move against each other by `of_side`;
/// infinite if it may rotate by any angle.
double turn_of(double length, double of_side) {
  return of_side < 0.5 * length ? of_side / (length - of_side)
                                : std::numeric_limits<double>::infinity();
}
double error_of(double distance, double of_point, double length, double of_side) {
  return error_of(distance, of_point, turn_of(length, of_side));
}
/// Returns an upper bound of the length of `line` times the error of a position across
/// it, without a square root. The line rotates by at most of_side / (length - of_side)
/// <= 2 of_side / length.
double scaled_error_of(double distance, double of_point, const Vec2& line,
                       double of_side) {
  if (!(of_side < 0.5 * line.lpNorm<Eigen::Infinity>()))
    return std::numeric_limits<double>::infinity();
  return (1.0 + 1e-9) *
             (of_point * line.lpNorm<1>() + (distance + of_point) * (2.0 * of_side)) +
         (1e-12 * distance + lost) * line.lpNorm<1>();
}

}  // namespace

UncoveredSide::UncoveredSide(const SideEnd& end, Outline other, double room,
                             double of_neighbours)
    : end_(end), other_(other),
      first_(start_of(end.polygon, static_cast<std::size_t>(end.side))), room_(room),
      of_neighbours_(of_neighbours), at_start_(end.at_start) {
  const Vec2 edge = end_of(end.polygon, static_cast<std::size_t>(end.side)) - first_;
  length_ = edge.norm();
  along_ = edge / length_;
  turn_ = turn_of(length_, room);
  PartBehind interval;
  double farthest = length_;
  for (std::size_t k = 0; k < other.size(); ++k) {
    const Vec2 line = end_of(other, k) - start_of(other, k);
    const Vec2 from = first_ - start_of(other, k);
    farthest = std::max(farthest, from.lpNorm<1>());
    // Depths are multiplied by the length of the line, because only their ratio
    // matters.
    const double depth = cross(from, line);
    interval.cut(depth, depth + cross(edge, line),
                 scaled_error_of(from.lpNorm<1>() + length_, room, line, room));
  }
  const double error = error_of(length_, room, turn_);
  least_ =
      length_ * (end.at_start ? interval.to.low : 1.0 - interval.from.high) - error;
  most_ = length_ * (end.at_start ? interval.to.high : 1.0 - interval.from.low) + error;
  is_empty_ = interval.from.low > interval.to.high;
  if (!(length_ > smallest && farthest < largest))
    give_up();
}

bool UncoveredSide::is_outside(const Vec2& start, const Vec2& end) const {
  for (std::size_t k = 0; k < other_.size(); ++k) {
    const Vec2 line = end_of(other_, k) - start_of(other_, k);
    const auto outside = [&](const Vec2& corner) {
      const Vec2 from = corner - start_of(other_, k);
      return cross(from, line) <
             -scaled_error_of(from.lpNorm<1>(), of_neighbours_, line, room_);
    };
    if (outside(start) && outside(end))
      return true;
  }
  return false;
}

bool UncoveredSide::is_less_deep(Outline neighbour, double depth) const {
  const Outline own = end_.polygon;
  for (std::size_t k = 0; k < own.size(); ++k) {
    if (static_cast<int>(k) == end_.side)
      continue;
    const Vec2& start = start_of(own, k);
    const Vec2 line = end_of(own, k) - start;
    double deepest = -std::numeric_limits<double>::infinity(), distance = 0.0;
    for (const Vec2& corner : neighbour) {
      deepest = std::max(deepest, cross(corner - start, line));
      distance = std::max(distance, (corner - start).lpNorm<1>());
    }
    const double of_line = line.norm();
    if (deepest / of_line + error_of(distance, of_neighbours_, of_line, room_) < depth)
      return true;
  }
  return false;
}

void UncoveredSide::add(Outline neighbour) {
  if (!is_sure() || is_empty_)
    return;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double low = infinite, high = -infinite, nearest = infinite, farthest = -infinite;
  for (const Vec2& corner : neighbour) {
    const Vec2 from = corner - first_;
    const double at = from.dot(along_), away = cross(along_, from);
    low = std::min(low, at), high = std::max(high, at);
    nearest = std::min(nearest, away), farthest = std::max(farthest, away);
  }
  const double far = std::max(high, -low) + std::max(farthest, -nearest);
  if (!(far < largest))
    return give_up();
  // The last term is the rounding error of the length.
  const double any_error = error_of(far, of_neighbours_, turn_) + 1e-12 * length_;
  if (!(any_error < largest))
    return give_up();
  // Positions along the side are measured from the tested end.
  const auto to_begin = [&](double begin, double last, double error) {
    return (at_start_ ? begin : length_ - last) - error;
  };
  const auto to_last = [&](double begin, double last, double error) {
    return (at_start_ ? last : length_ - begin) + error;
  };
  if (to_begin(low, high, any_error) >= most_ || to_last(low, high, any_error) <= 0.0 ||
      nearest - any_error > most_)
    return;
  for (std::size_t f = 0; f < neighbour.size(); ++f) {
    const Vec2 &near = end_of(neighbour, f), &far_end = start_of(neighbour, f);
    // `across` has about the direction of the side if the two sides face each other.
    const Vec2 across = far_end - near;
    // The cosine of 10 degrees is 0.985. If the two sides face each other after the
    // motion, `product` + 1.985 of_neighbours + 2 room of_across / length is at least
    // 0.985 of_across.
    const double product = across.dot(along_), square = across.squaredNorm();
    if (!(square > smallest * smallest))
      return give_up();
    const double facing = product + 2.0 * of_neighbours_,
                 part = 0.95 - 2.0 * room_ / length_;
    if (part > 0.0 && (facing < 0.0 || facing * facing < part * part * square))
      continue;
    // Only the part of a long side that can come to lie along the tested side counts.
    // It moves by less than `error`, which is less than the length of the tested side.
    const double start = (near - first_).dot(along_);
    double first_part = 0.0, last_part = 1.0;
    if (product > 2.0 * length_)
      first_part = std::max(0.0, (-length_ - start) / product),
      last_part = std::min(1.0, (2.0 * length_ - start) / product);
    const Vec2 nearest_part = near + first_part * across - first_,
               farthest_part = near + last_part * across - first_;
    const double error =
        error_of(std::max(nearest_part.lpNorm<1>(), farthest_part.lpNorm<1>()),
                 of_neighbours_, turn_) +
        1e-12 * length_;
    if (product > 2.0 * length_ && !(error < length_))
      return give_up();
    if (first_part >= last_part)
      continue;
    const double begin = nearest_part.dot(along_), last = farthest_part.dot(along_);
    const double from = std::max(0.0, to_begin(begin, last, error)),
                 to = to_last(begin, last, error);
    const double gap_at_near = cross(along_, nearest_part),
                 gap_at_far = cross(along_, farthest_part);
    const double gap = std::min(gap_at_near, gap_at_far) - error,
                 overlap = -std::max(gap_at_near, gap_at_far) - error;
    double least = std::max(least_, gap), most = most_;
    if (least > most || from >= most || to <= 0.0)
      continue;
    // Side f covers (min(h, to) - from) / h of the stretch. The share is largest if h
    // is `to`.
    const auto share = [&] {
      const double h = std::clamp(to, least, most);
      return std::max(0.0, std::min(h, to) - from) / h;
    };
    const double of_across = std::sqrt(square);
    double reach = -std::numeric_limits<double>::infinity(), distance = 0.0;
    for (const Vec2& corner : other_) {
      reach = std::max(reach, cross(across, corner - far_end) / of_across);
      distance = std::max(distance, (corner - far_end).lpNorm<1>());
    }
    most = std::min(
        most, reach + error_of(distance, of_neighbours_, of_across, of_neighbours_));
    if (least > most || from >= most)
      continue;
    // The two polygons do not touch along these sides if another axis is less deep than
    // both the tested side and f. If f is behind the tested side by y, points of that
    // side are below f by at least y cos 10 degrees.
    if (overlap > 0.0 && is_less_deep(neighbour, 0.98 * overlap))
      continue;
    if (is_outside(near, far_end)) {
      if (gap > 0.0)
        continue;
      least = std::max(least, overlap);
      if (least > most)
        continue;
    }
    share_ += share();
  }
}

}  // namespace blocks::geometry
