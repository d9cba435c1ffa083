#include "sweep/layer_measures.hpp"

#include <cmath>
#include <utility>

#include "geometry/block_shape.hpp"
#include "geometry/joint_network.hpp"
#include "quantities/statistic.hpp"

namespace blocks::sweep {
namespace {

using Json = nlohmann::ordered_json;

/// Finds where the sides of the blocks of one layer meet its mid-line.
class MidLine {
 public:
  MidLine(const Blocks& blocks, const LayerRecord& layer) : blocks_(blocks) {
    const int last = layer.first_block + layer.blocks - 1;
    start_ = 0.5 * (corner(layer.first_block, bottom_left) +
                    corner(layer.first_block, top_left));
    along_ = 0.5 * (corner(last, bottom_right) + corner(last, top_right)) - start_;
  }
  double width(int block) const {
    return along_.stableNorm() * (place(block, bottom_right, top_right) -
                                  place(block, bottom_left, top_left));
  }

 private:
  // The corners of the blocks of a layer, in their order.
  enum Corner { bottom_left, top_left, top_right, bottom_right };

  Vec2 corner(int block, Corner which) const {
    return blocks_.corner.col(blocks_.first_corner[block] + which);
  }
  /// The place of a side on the mid-line, from 0 at its start to 1 at its end.
  double place(int block, Corner bottom, Corner top) const {
    const Vec2 foot = corner(block, bottom), side = corner(block, top) - foot;
    return geometry::cross(foot - start_, side) / geometry::cross(along_, side);
  }

  const Blocks& blocks_;
  Vec2 start_, along_;
};

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json spread(const Spread& s) {
  return {{"min", number(s.min)}, {"mean", number(s.mean)}, {"max", number(s.max)},
          {"sd", number(s.sd)},   {"p5", number(s.p5)},     {"p50", number(s.p50)},
          {"p95", number(s.p95)}};
}

}  // namespace

Spread spread_of(std::vector<double> values) {
  using quantities::Statistic;
  using How = Statistic::How;
  Spread result;
  if (values.empty())
    return result;
  const auto reduced = [&](How how, double percent = 0.0) {
    return quantities::reduce(Statistic{how, percent}, values);
  };
  result.min = reduced(How::smallest);
  result.mean = reduced(How::mean);
  result.max = reduced(How::largest);
  if (values.size() > 1) {
    double squares = 0.0;
    for (const double value : values)
      squares += (value - result.mean) * (value - result.mean);
    result.sd = std::sqrt(squares / static_cast<double>(values.size() - 1));
  }
  // The percentiles reorder the values, so they come last.
  result.p5 = reduced(How::percentile, 5.0);
  result.p50 = reduced(How::percentile, 50.0);
  result.p95 = reduced(How::percentile, 95.0);
  return result;
}

std::vector<double> widths_of_layer(const Blocks& blocks, const LayerRecord& layer) {
  std::vector<double> widths;
  if (layer.blocks == 0)
    return widths;
  const MidLine line(blocks, layer);
  for (int b = layer.first_block; b < layer.first_block + layer.blocks; ++b)
    if (!blocks.is_removed(b))
      widths.push_back(line.width(b));
  return widths;
}

LayerMeasures measure_layers(const Model& model, const SharedCertificate& certificate) {
  const Blocks& blocks = model.blocks;
  LayerMeasures result;
  result.layers = static_cast<int>(model.layers.size());
  result.absorbed = static_cast<int>(model.merges.size());
  for (const LayerRecord& layer : model.layers) {
    result.angles_redrawn += layer.redrawn;
    result.sides_redrawn += layer.redrawn_sides;
    result.sides_ruled += layer.ruled;
  }
  std::vector<geometry::Polygon> outlines;
  std::vector<double> area, aspect, side, angle;
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b) || (result.layers > 0 && blocks.layer[b] == 0))
      continue;
    const auto shape =
        geometry::measure_shape(outlines.emplace_back(blocks.outline(b)));
    area.push_back(shape.area);
    aspect.push_back(shape.aspect);
    side.push_back(shape.shortest_edge);
    angle.push_back(shape.smallest_angle);
  }
  result.blocks = static_cast<int>(outlines.size());
  double total = 0.0;
  for (const double one : area)
    total += one;
  result.area = spread_of(std::move(area));
  result.aspect = spread_of(std::move(aspect));
  result.shortest_side = spread_of(std::move(side));
  result.smallest_angle = spread_of(std::move(angle));
  std::vector<double> widths;
  for (const LayerRecord& layer : model.layers)
    if (!certificate || layer.first_block >= certificate->moved)
      for (const double width : widths_of_layer(blocks, layer))
        widths.push_back(width);
  result.width = spread_of(std::move(widths));
  const geometry::JointNetwork network = geometry::find_joint_network(outlines);
  if (result.blocks > 0)
    result.p21 = network.length / total;
  result.t_vertices = network.t_vertices;
  result.x_vertices = network.x_vertices;
  if (certificate) {
    result.certificate = certificate->holds();
    result.overlaps = static_cast<int>(certificate->overlaps.size());
    result.gaps = static_cast<int>(certificate->gaps());
  }
  return result;
}

nlohmann::ordered_json to_json(const LayerMeasures& m) {
  return {{"layers", m.layers},
          {"blocks", m.blocks},
          {"absorbed", m.absorbed},
          {"angles_redrawn", m.angles_redrawn},
          {"sides_redrawn", m.sides_redrawn},
          {"sides_ruled", m.sides_ruled},
          {"area", spread(m.area)},
          {"aspect", spread(m.aspect)},
          {"shortest_side", spread(m.shortest_side)},
          {"smallest_angle", spread(m.smallest_angle)},
          {"width", spread(m.width)},
          {"p21", number(m.p21)},
          {"t_vertices", m.t_vertices},
          {"x_vertices", m.x_vertices},
          {"certificate", m.certificate},
          {"overlaps", m.overlaps},
          {"gaps", m.gaps}};
}

}  // namespace blocks::sweep
