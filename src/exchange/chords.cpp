#include "exchange/chords.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "exchange/block_record.hpp"
#include "geometry/angle.hpp"

namespace blocks::exchange {
namespace {

using geometry::Vec2;

constexpr int max_halvings = 12;  // for curves that the range of numbers distorts

/// The error that rounding of coordinates of this size may have, [L].
double unit_of(const Vec2& p) { return 0x1p-50 * p.lpNorm<Eigen::Infinity>(); }

double tangent(double degrees) {
  return geometry::tangent_of_degrees(
      geometry::Decimal::parse(shortest(degrees)).value());
}

/// A control point in homogeneous coordinates, (x w, y w, w).
using Homogeneous = Eigen::Vector3d;
using Bezier = std::vector<Homogeneous>;

Vec2 place(const Homogeneous& p) { return p.head<2>() / p.z(); }

/// The polar form of the spline in span k (knots k to k + 1), with one argument for
/// each degree.
Homogeneous blossom(const Spline& spline, std::size_t k,
                    const std::vector<double>& arguments) {
  const auto p = static_cast<std::size_t>(spline.degree);
  std::vector<Homogeneous> d;
  for (std::size_t j = k - p; j <= k; ++j) {
    const double w = spline.weights[j];
    d.emplace_back(spline.points[j].x() * w, spline.points[j].y() * w, w);
  }
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t j = p; j >= r; --j) {
      const std::size_t i = k - p + j;
      const double low = spline.knots[i], high = spline.knots[i + p + 1 - r];
      const double t = (arguments[r - 1] - low) / (high - low);
      d[j] = (1.0 - t) * d[j - 1] + t * d[j];
    }
  return d[p];
}

/// A bound of the distance between the curve and its chord.
double distance_from_chord(const Bezier& curve) {
  const Vec2 from = place(curve.front()), chord = place(curve.back()) - from;
  const double length = chord.squaredNorm();
  double largest = 0.0;
  for (const Homogeneous& point : curve) {
    const Vec2 arm = place(point) - from;
    const double along =
        length > 0.0 ? std::clamp(arm.dot(chord) / length, 0.0, 1.0) : 0.0;
    largest = std::max(largest, (arm - along * chord).norm());
  }
  return largest;
}

/// Appends the ends of the chords, without the first point.
void add_bezier(Bezier curve, int halvings, ChordError& error,
                std::vector<Vec2>& points) {
  const double distance = distance_from_chord(curve);
  const double allowed = std::max(error.allowed, unit_of(place(curve.front())));
  if (!(distance > allowed) || halvings == max_halvings) {
    error.largest = std::max(error.largest, distance);
    points.push_back(place(curve.back()));
    return;
  }
  Bezier first;  // de Casteljau at 1/2
  for (std::size_t n = curve.size(); n > 0; --n) {
    first.push_back(curve.front());
    for (std::size_t i = 0; i + 1 < n; ++i)
      curve[i] = 0.5 * (curve[i] + curve[i + 1]);
  }
  add_bezier(std::move(first), halvings + 1, error, points);
  add_bezier(std::move(curve), halvings + 1, error, points);
}

void halve_arc(const Vec2& p, const Vec2& q, double bulge, int halvings,
               ChordError& error, std::vector<Vec2>& points) {
  const Vec2 chord = q - p;
  const double rise = 0.5 * std::abs(bulge) * chord.norm();
  const double allowed = std::max(error.allowed, unit_of(p));
  if (!(rise > allowed) || halvings == max_halvings) {
    error.largest = std::max(error.largest, rise);
    points.push_back(q);
    return;
  }
  const Vec2 middle = 0.5 * (p + q) + 0.5 * bulge * Vec2(chord.y(), -chord.x());
  const double half = bulge / (1.0 + std::sqrt(1.0 + bulge * bulge));
  halve_arc(p, middle, half, halvings + 1, error, points);
  halve_arc(middle, q, half, halvings + 1, error, points);
}

}  // namespace

Vec2 unit_vector(double degrees) {
  double angle = std::remainder(degrees, 360.0);  // exact
  double sign = 1.0;
  if (std::abs(angle) > 90.0) {
    angle -= std::copysign(180.0, angle);
    sign = -1.0;
  }
  const double t = tangent(0.5 * angle), length = 1.0 + t * t;
  return {sign * (1.0 - t * t) / length, sign * 2.0 * t / length};
}

void add_arc(const Vec2& p, const Vec2& q, double bulge, ChordError& error,
             std::vector<Vec2>& points) {
  halve_arc(p, q, bulge, 0, error, points);
}

std::vector<Vec2> unit_arc(double from, double turn, ChordError& error) {
  std::vector<Vec2> points{unit_vector(from)};
  const Vec2 begin = points.front(), middle = unit_vector(from + 0.5 * turn);
  const double bulge = tangent(0.125 * turn);
  add_arc(begin, middle, bulge, error, points);
  add_arc(middle, turn == 360.0 ? begin : unit_vector(from + turn), bulge, error,
          points);
  return points;
}

const char* fault_of(const Spline& spline) {
  if (spline.degree < 1 || spline.degree > 25)
    return "its degree is not between 1 and 25";
  const auto p = static_cast<std::size_t>(spline.degree);
  if (spline.points.size() < p + 1)
    return "it has fewer control points than its degree needs";
  if (spline.knots.size() != spline.points.size() + p + 1)
    return "its knots are not as many as control points + degree + 1";
  if (!std::is_sorted(spline.knots.begin(), spline.knots.end()))
    return "its knots decrease";
  if (!(spline.knots[p] < spline.knots[spline.points.size()]))
    return "its knots are all equal";
  for (std::size_t i = 0; i + p + 1 < spline.knots.size(); ++i)
    if (!std::isfinite(spline.knots[i + p + 1] - spline.knots[i]))
      return "its knots are too far apart";
  if (std::any_of(spline.weights.begin(), spline.weights.end(),
                  [](double w) { return !(w > 0.0); }))
    return "a weight is not above 0";
  return "";
}

std::vector<Vec2> spline_chords(const Spline& spline, ChordError& error) {
  const auto p = static_cast<std::size_t>(spline.degree);
  std::vector<Vec2> points;
  for (std::size_t k = p; k < spline.points.size(); ++k) {
    const double low = spline.knots[k], high = spline.knots[k + 1];
    if (!(low < high))
      continue;
    Bezier curve;
    for (std::size_t j = 0; j <= p; ++j) {
      std::vector<double> arguments(p, low);
      std::fill_n(arguments.begin(), j, high);
      curve.push_back(blossom(spline, k, arguments));
    }
    if (points.empty())
      points.push_back(place(curve.front()));
    add_bezier(std::move(curve), 0, error, points);
  }
  return points;
}

}  // namespace blocks::exchange
