#include "run/reports/geometry_report.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/block_shape.hpp"

namespace blocks::run {
namespace {

constexpr std::size_t max_listed = 10;
constexpr int classes = 8;

/// Forms classes of equal width, or of equal ratio if the values span a factor above
/// 30.
void classify(const std::vector<double>& values, Measure& measure) {
  const double low = measure.smallest, high = measure.largest;
  // Values that differ only by round-off form one class.
  if (high - low <= 1e-9 * high) {
    measure.edges = {low, high};
    measure.counts = {static_cast<long>(values.size())};
    return;
  }
  const bool by_ratio = low > 0.0 && high > 30.0 * low;
  for (int i = 0; i <= classes; ++i) {
    const double part = static_cast<double>(i) / classes;
    measure.edges.push_back(by_ratio ? low * std::pow(high / low, part)
                                     : low + (high - low) * part);
  }
  measure.edges.back() = high;
  measure.counts.assign(classes, 0);
  for (const double value : values) {
    const auto above =
        std::upper_bound(measure.edges.begin() + 1, measure.edges.end() - 1, value);
    ++measure.counts[static_cast<std::size_t>(above - measure.edges.begin() - 1)];
  }
}

/// If `sign` is +1, the smallest values are the worst; if it is -1, the largest are.
Measure measure_of(const std::vector<Measure::Place>& places, double sign) {
  Measure measure;
  if (places.empty())
    return measure;
  std::vector<double> values;
  for (const auto& place : places)
    values.push_back(place.value);
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  measure.smallest = values.front();
  measure.median = 0.5 * (values[(n - 1) / 2] + values[n / 2]);
  measure.largest = values.back();
  classify(values, measure);
  measure.worst.resize(std::min(n, max_listed));
  std::partial_sort_copy(places.begin(), places.end(), measure.worst.begin(),
                         measure.worst.end(), [sign](const auto& a, const auto& b) {
                           return a.value != b.value ? sign * a.value < sign * b.value
                                                     : a.block < b.block;
                         });
  // Half of the blocks are no worse than the median; they are not outliers.
  const double limit = sign * measure.median - 1e-9 * measure.median;
  std::erase_if(measure.worst, [&](const Measure::Place& place) {
    return sign * place.value >= limit;
  });
  return measure;
}

}  // namespace

GeometryReport examine_geometry(const std::string& file, const Model& model,
                                int moved) {
  const Blocks& blocks = model.blocks;
  GeometryReport report;
  report.file = file;
  report.blocks = blocks.count_present();
  report.layers = model.layers;
  report.merges = model.merges;
  report.cuts = model.cuts;
  report.joint_lengths = model.joint_lengths;
  std::vector<Measure::Place> area, aspect, edge, angle;
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b))
      continue;
    report.corners += blocks.corners_of(b);
    if (!model.cuts.empty())
      ++report.sides[blocks.corners_of(b)];
    const geometry::Polygon outline = blocks.outline(b);
    const auto shape = geometry::measure_shape(outline);
    const Vec2 middle = blocks.centroid.col(b);
    const auto corner = [&](int c) { return outline[static_cast<std::size_t>(c)]; };
    const int next = (shape.edge + 1) % static_cast<int>(outline.size());
    area.push_back({shape.area, b, 0, middle});
    aspect.push_back({shape.aspect, b, 0, middle});
    edge.push_back({shape.shortest_edge, b, shape.edge,
                    0.5 * (corner(shape.edge) + corner(next))});
    angle.push_back({shape.smallest_angle, b, shape.corner, corner(shape.corner)});
  }
  report.area = measure_of(area, 1.0);
  report.aspect = measure_of(aspect, -1.0);
  report.edge = measure_of(edge, 1.0);
  report.angle = measure_of(angle, 1.0);
  report.certificate = certify_assembly(blocks, moved);
  return report;
}

}  // namespace blocks::run
