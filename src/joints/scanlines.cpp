#include "joints/scanlines.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "joints/window.hpp"

namespace blocks::joints {

using geometry::cross;
using geometry::Vec2;

namespace {

/// The parts of a scanline inside the window [L].
std::vector<std::pair<double, double>> inside(const Scanline& line,
                                              const Network& network) {
  const double length = (line.to - line.from).norm();
  std::vector<std::pair<double, double>> found;
  for (auto [begin, end] : chords(network.window, line.from, line.to - line.from)) {
    begin = std::max(begin, 0.0), end = std::min(end, 1.0);
    if (begin < end)
      found.emplace_back(begin * length, end * length);
  }
  return found;
}

}  // namespace

std::vector<Crossing> crossings_of(const Scanline& line, const Network& network) {
  const Vec2 whole = line.to - line.from, along = whole.normalized();
  const auto parts = inside(line, network);
  std::vector<Crossing> found;
  for (const Part& part : network.parts) {
    const double s = cross(along, part.from - line.from);
    const double t = cross(along, part.to - line.from);
    // A bend on the line is above it, so a trace through it counts once.
    if ((s >= 0.0) == (t >= 0.0))
      continue;
    const Vec2 run = part.to - part.from;
    const double place = along.dot(part.from + run * (s / (s - t)) - line.from);
    for (std::size_t chord = 0; chord < parts.size(); ++chord)
      if (place >= parts[chord].first && place <= parts[chord].second) {
        found.push_back(
            {place, chord, part.piece, std::abs(cross(along, run)) / run.norm()});
        break;
      }
  }
  std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.place, a.piece) < std::tie(b.place, b.piece);
  });
  return found;
}

SpacingStatistics spacing_statistics(const std::vector<Scanline>& lines,
                                     const Network& network,
                                     const std::vector<char>& chosen) {
  constexpr double min_cosine = 0.1;  // nearly parallel traces would count too much
  SpacingStatistics sum;
  std::vector<double> spacings;
  for (const Scanline& line : lines) {
    for (const auto& [begin, end] : inside(line, network))
      sum.length += end - begin;
    const Crossing* last = nullptr;
    const std::vector<Crossing> all = crossings_of(line, network);
    for (const Crossing& one : all) {
      if (!chosen.empty() && chosen[one.piece] == 0)
        continue;
      ++sum.crossings;
      sum.corrected += 1.0 / std::max(one.cosine, min_cosine);
      if (last != nullptr && last->chord == one.chord)
        spacings.push_back(one.place - last->place);
      last = &one;
    }
  }
  if (sum.length > 0.0) {
    sum.frequency = static_cast<double>(sum.crossings) / sum.length;
    sum.corrected /= sum.length;
  }
  sum.spacings = spacings.size();
  const auto n = static_cast<double>(spacings.size());
  for (const double one : spacings)
    sum.mean += one / n;
  double squares = 0.0;
  for (const double one : spacings)
    squares += (one - sum.mean) * (one - sum.mean);
  if (spacings.size() > 1 && sum.mean > 0.0)
    sum.variation = std::sqrt(squares / (n - 1.0)) / sum.mean;
  return sum;
}

std::vector<Scanline> parallel_scanlines(const geometry::Polygon& window,
                                         double degrees, int count) {
  const Vec2 along = unit_vector(degrees), across(-along.y(), along.x());
  const Vec2 origin = window.front();
  double left = 0.0, right = 0.0, low = 0.0, high = 0.0;
  for (const Vec2& corner : window) {
    const double u = along.dot(corner - origin), v = across.dot(corner - origin);
    left = std::min(left, u), right = std::max(right, u);
    low = std::min(low, v), high = std::max(high, v);
  }
  // The lines begin and end outside of the window.
  const double margin = 0.01 * (right - left);
  std::vector<Scanline> lines;
  for (int k = 0; k < count; ++k) {
    const Vec2 foot = origin + across * (low + (high - low) * (k + 0.5) / count);
    lines.push_back({foot + along * (left - margin), foot + along * (right + margin)});
  }
  return lines;
}

}  // namespace blocks::joints
