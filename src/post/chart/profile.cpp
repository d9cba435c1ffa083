#include "post/chart/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace blocks::post {
namespace {

using Outline = std::vector<Eigen::Vector2d>;

/// The interval along the line, from `origin` in `direction`, between the outermost
/// crossings with an outline.
struct Crossing {
  double from = std::numeric_limits<double>::infinity(), to = -from;
};
Crossing cross(const Outline& outline, const Eigen::Vector2d& origin,
               const Eigen::Vector2d& direction) {
  const Eigen::Vector2d normal(-direction.y(), direction.x());
  Crossing met;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d a = outline[i] - origin,
                          b = outline[(i + 1) % outline.size()] - origin;
    const double above = a.dot(normal), below = b.dot(normal);
    if ((above > 0.0) == (below > 0.0))
      continue;
    const double s = above / (above - below);
    const double at = (a + s * (b - a)).dot(direction);
    met.from = std::min(met.from, at);
    met.to = std::max(met.to, at);
  }
  return met;
}

std::vector<ProfilePlace> along(const Frame& first, const Eigen::Vector4d& segment) {
  const Eigen::Vector2d origin = segment.head<2>(),
                        way = segment.tail<2>() - segment.head<2>();
  const double length = way.norm();
  std::vector<ProfilePlace> places;
  for (int b = 0; b < first.size(); ++b) {
    const Crossing met =
        cross(first.outlines[static_cast<std::size_t>(b)], origin, way / length);
    const double from = std::max(met.from, 0.0), to = std::min(met.to, length);
    if (to - from > 1e-9 * length)  // a corner that only touches does not count
      places.push_back({b + 1, 0.5 * (from + to)});
  }
  return places;
}

/// Blocks are sorted into vertical strips, so that each is compared with few others.
std::vector<ProfilePlace> surface(const Frame& first) {
  const auto n = static_cast<std::size_t>(first.size());
  std::vector<double> low(n, std::numeric_limits<double>::infinity()), high(n);
  double left = low.empty() ? 0.0 : low[0], right = -left;
  for (std::size_t b = 0; b < n; ++b) {
    high[b] = -low[b];
    for (const Eigen::Vector2d& p : first.outlines[b]) {
      low[b] = std::min(low[b], p.x());
      high[b] = std::max(high[b], p.x());
    }
    left = std::min(left, low[b]);
    right = std::max(right, high[b]);
  }
  std::vector<std::vector<std::size_t>> strips(std::clamp<std::size_t>(n, 1, 2000));
  const auto strip = [&](double x) {
    const double part = (x - left) / std::max(right - left, 1e-300);
    return std::min(static_cast<std::size_t>(std::max(part, 0.0) *
                                             static_cast<double>(strips.size())),
                    strips.size() - 1);
  };
  std::vector<std::size_t> present;
  for (std::size_t b = 0; b < n; ++b)
    if (!first.outlines[b].empty())  // it is empty if the block is removed
      present.push_back(b);
  for (const std::size_t b : present)
    for (std::size_t s = strip(low[b]); s <= strip(high[b]); ++s)
      strips[s].push_back(b);
  std::vector<ProfilePlace> places;
  for (const std::size_t b : present) {
    const double x = first.centroid(0, static_cast<Eigen::Index>(b));
    double highest = -std::numeric_limits<double>::infinity(), own = highest;
    for (const std::size_t other : strips[strip(x)]) {
      const double top = cross(first.outlines[other], {x, 0.0}, {0.0, 1.0}).to;
      highest = std::max(highest, top);
      if (other == b)
        own = top;
    }
    if (own == highest && std::isfinite(own))
      places.push_back({static_cast<int>(b) + 1, x});
  }
  return places;
}

}  // namespace

ProfileLine ProfileLine::parse(const std::string& text) {
  if (text == "top")
    return {};
  std::istringstream in(text);
  Eigen::Vector4d v;
  char comma = ',';
  for (int i = 0; i < 4 && in; ++i) {
    if (i > 0)
      in >> comma;
    in >> v[i];
    if (comma != ',')
      in.setstate(std::ios::failbit);
  }
  if (!in || in.peek() != std::char_traits<char>::eof() || !v.allFinite() ||
      v.head<2>() == v.tail<2>())
    throw std::runtime_error("a profile is 'top' or a line x0,y0,x1,y1 between two "
                             "different points, found '" +
                             text + "'");
  return {v};
}

std::vector<ProfilePlace> profile_places(const Frame& first, const ProfileLine& line) {
  std::vector<ProfilePlace> places =
      line.segment ? along(first, *line.segment) : surface(first);
  if (places.empty()) {
    const Eigen::Vector2d low = first.centroid.rowwise().minCoeff(),
                          high = first.centroid.rowwise().maxCoeff();
    throw std::runtime_error(fmt::format(
        "the profile meets no block: their centroids lie in x {:g} to {:g}, y {:g} to "
        "{:g}",
        low.x(), high.x(), low.y(), high.y()));
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const ProfilePlace& a, const ProfilePlace& b) {
                     return a.position < b.position;
                   });
  return places;
}

std::vector<ProfilePlace> both_halves(const std::vector<ProfilePlace>& places,
                                      double plane) {
  std::vector<ProfilePlace> both = places;
  for (const ProfilePlace& place : places)
    if (place.position != plane)
      both.push_back({place.block, 2.0 * plane - place.position, plane});
  std::stable_sort(both.begin(), both.end(),
                   [](const ProfilePlace& a, const ProfilePlace& b) {
                     return a.position < b.position;
                   });
  return both;
}

std::vector<double> profile_values(const std::vector<ProfilePlace>& places,
                                   const QuantityKind& kind, const Frame& now,
                                   const Frame& first) {
  const Eigen::VectorXd all = values_of(kind, now, first);
  std::vector<double> values;
  for (const ProfilePlace& place : places)
    values.push_back(
        place.mirror
            ? in_mirror(kind.name, all.segment(place.block - 1, 1), *place.mirror)[0]
            : all[place.block - 1]);
  return values;
}

}  // namespace blocks::post
