#include "validation/cells/sample.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace blocks::validation {
namespace {

using geometry::cross;
using geometry::CutRequest;
using geometry::CutResult;
using geometry::Vec2;

bool is_lower(const Vec2& a, const Vec2& b) {
  return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
}

void add_cell(const std::vector<Vec2>& corners, double mean_area, Sums& sums) {
  double twice = 0.0, around = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    twice += cross(b - corners[0], a - corners[0]);  // the corners are clockwise
    around += (b - a).norm();
  }
  const auto n = static_cast<int>(corners.size());
  const double size = twice / 2.0;
  sums[sum::cells] += 1.0;
  sums[sum::area] += size;
  sums[sum::area_square] += size * size;
  sums[sum::perimeter] += around;
  sums[sum::sides] += n;
  sums[sum::sides_square] += n * n;
  sums[sum::triangles] += n == 3 ? 1.0 : 0.0;
  sums[sum::quadrangles] += n == 4 ? 1.0 : 0.0;
  sums[sum::first_side_bin + std::min(n, sum::side_bins - 1)] += 1.0;
  const double bin = size / (mean_area * sum::area_bin_width);
  if (bin < sum::area_bins)
    sums[sum::first_area_bin + static_cast<int>(bin)] += 1.0;
}

bool holds(const CutRequest& request, const CutResult& result, Identity identity) {
  const std::size_t count = result.mesh.cells.size();
  if (identity == Identity::lines)
    return count == 1 + lines_and_crossings(request);
  const std::size_t inner = result.mesh.vertices.size() - result.mesh.outline.size(),
                    nodes = result.mesh.outline.size() - request.outline.size();
  return inner + nodes == 2 * (count - 1);
}

}  // namespace

std::size_t lines_and_crossings(const CutRequest& request) {
  std::vector<Vec2> outline;
  for (const geometry::DecimalPoint& p : request.outline)
    outline.emplace_back(p.x.value(), p.y.value());
  // Places of the ends along the outline: number of the side, plus the part of it.
  std::vector<std::pair<double, double>> chords;
  for (const geometry::JointSegment& line : request.joints) {
    const Vec2 from = line.from.nearest(), along = line.to.nearest() - from;
    std::vector<double> ends;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const double a = cross(along, outline[i] - from),
                   b = cross(along, outline[(i + 1) % outline.size()] - from);
      if ((a > 0.0) != (b > 0.0))
        ends.push_back(static_cast<double>(i) + a / (a - b));
    }
    if (ends.size() == 2)
      chords.emplace_back(ends[0], ends[1]);
  }
  std::size_t count = chords.size();
  for (std::size_t i = 0; i < chords.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto between = [&](double end) {
        return end > chords[i].first && end < chords[i].second;
      };
      count += between(chords[j].first) != between(chords[j].second) ? 1 : 0;
    }
  return count;
}

Sums sample(const CutRequest& request, const Window& window, Identity identity,
            double mean_area) {
  const CutResult result = cut_outline(request);
  Sums sums = Sums::Zero(sum::count);
  sums[sum::networks] = 1.0;
  sums[sum::faces] = static_cast<double>(result.mesh.cells.size());
  sums[sum::p21] = result.report.p21_before;
  if (identity != Identity::none) {
    sums[sum::identities] = 1.0;
    sums[sum::broken] = holds(request, result, identity) ? 0.0 : 1.0;
  }
  const std::set<int> on_outline(result.mesh.outline.begin(),
                                 result.mesh.outline.end());
  for (const geometry::CutBlock& block : result.blocks) {
    std::vector<Vec2> corners;
    for (const int v : block.corners)
      corners.push_back(result.mesh.vertices[static_cast<std::size_t>(v)]);
    // A clockwise cell has each inner edge once from its lower end; its twin has the
    // other direction.
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (is_lower(a, b) && window.contains(a)) {
        sums[sum::edges] += 1.0;
        sums[sum::edge_length] += (b - a).norm();
      }
    }
    if (!window.contains(*std::min_element(corners.begin(), corners.end(), is_lower)))
      continue;
    add_cell(corners, mean_area, sums);
    const bool touches = std::any_of(block.corners.begin(), block.corners.end(),
                                     [&](int v) { return on_outline.count(v) > 0; });
    sums[sum::clipped] += touches ? 1.0 : 0.0;
  }
  return sums;
}

}  // namespace blocks::validation
