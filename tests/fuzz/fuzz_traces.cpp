// Reads any bytes as a file of traces and as a file of points. What can be read cuts a
// square, and the box of its own coordinates, with and without cleaning. A slow judge
// on rationals examines the blocks; a refusal has a place and a hint.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "exchange/trace_reader.hpp"
#include "geometry/joint_sources.hpp"
#include "tests/geometry/area_judge.hpp"

namespace {

using namespace blocks;
using geometry::CutRequest;
using geometry::Decimal;
using geometry::DecimalPoint;
using geometry::Polygon;
using geometry::Vec2;
using Rational = geometry::testing::Exact;

constexpr std::size_t max_segments = 40, max_points = 30;

void require(bool holds) {
  if (!holds)
    std::abort();
}

/// Twice the area of a clockwise polygon, exactly.
Rational twice_area(const Polygon& p) {
  Rational sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    sum += Rational(b.x()) * Rational(a.y()) - Rational(a.x()) * Rational(b.y());
  }
  return sum;
}

bool boxes_overlap(const Polygon& p, const Polygon& q) {
  const auto lowest = [](const Polygon& corners) {
    Vec2 low = corners[0];
    for (const Vec2& corner : corners)
      low = low.cwiseMin(corner);
    return low;
  };
  const auto highest = [](const Polygon& corners) {
    Vec2 high = corners[0];
    for (const Vec2& corner : corners)
      high = high.cwiseMax(corner);
    return high;
  };
  return (lowest(p).array() < highest(q).array()).all() &&
         (lowest(q).array() < highest(p).array()).all();
}

void require_disjoint(const std::vector<Polygon>& polygons) {
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for (std::size_t j = i + 1; j < polygons.size(); ++j)
      require(!boxes_overlap(polygons[i], polygons[j]) ||
              geometry::testing::common_area(polygons[i], polygons[j]) == 0);
}

void judge(const geometry::CutResult& result) {
  const auto polygon = [&result](const std::vector<int>& loop) {
    Polygon corners;
    for (const int v : loop)
      corners.push_back(result.mesh.vertices.at(static_cast<std::size_t>(v)));
    return corners;
  };
  std::vector<Polygon> cells, blocks;
  Rational sum = 0;
  require(result.blocks.size() == result.mesh.cells.size());
  for (std::size_t i = 0; i < result.blocks.size(); ++i) {
    cells.push_back(polygon(result.mesh.cells[i]));
    blocks.push_back(polygon(result.blocks[i].corners));
    const Rational area = twice_area(cells.back());
    require(area > 0 && twice_area(blocks.back()) > 0 &&
            twice_area(blocks.back()) <= area);
    require(result.blocks[i].joints.size() == blocks.back().size());
    sum += area;
  }
  require(sum == twice_area(polygon(result.mesh.outline)));
  require_disjoint(cells);
  require_disjoint(blocks);
}

/// Runs a step that may refuse its input.
template <class Step> void attempt(const Step& step) {
  try {
    step();
  } catch (const geometry::CutError& error) {
    require(error.what()[0] != '\0' && !error.hint.empty() && error.place.allFinite());
  }
}

struct Domain {
  std::vector<DecimalPoint> outline;
  double size;  ///< [L] the shorter side
};

Decimal number(std::string_view text) { return Decimal::parse(text).value(); }

Domain rectangle(const DecimalPoint& low, const DecimalPoint& high) {
  return {{low, {low.x, high.y}, high, {high.x, low.y}},
          std::min(high.x.value() - low.x.value(), high.y.value() - low.y.value())};
}

/// Returns the square of 10 x 10 and the box of the points, unless it is flat.
std::vector<Domain> domains(const std::vector<DecimalPoint>& points) {
  std::vector<Domain> result = {
      rectangle({number("0"), number("0")}, {number("10"), number("10")})};
  DecimalPoint low = points[0], high = points[0];
  for (const DecimalPoint& p : points) {
    if (p.x.value() < low.x.value())
      low.x = p.x;
    if (p.y.value() < low.y.value())
      low.y = p.y;
    if (p.x.value() > high.x.value())
      high.x = p.x;
    if (p.y.value() > high.y.value())
      high.y = p.y;
  }
  if (low.x.value() < high.x.value() && low.y.value() < high.y.value())
    result.push_back(rectangle(low, high));
  return result;
}

void cut(const Domain& domain, const std::vector<geometry::JointSegment>& joints) {
  for (const double part : {0.0, 0.05}) {
    attempt([&] {
      CutRequest request;
      request.outline = domain.outline;
      request.joints = joints;
      request.emin = part * domain.size;
      request.amin = request.emin * request.emin;
      judge(geometry::cut_outline(request));
    });
  }
}

void use_traces(std::string_view text) {
  const exchange::TraceFile file = exchange::read_traces(text);
  exchange::format(file.messages, "fuzz", file.form, text);
  if (has_errors(file.messages))
    return;
  require(!file.traces.empty());
  std::vector<DecimalPoint> points;
  std::vector<geometry::JointSegment> joints;
  for (const exchange::Trace& trace : file.traces)
    for (std::size_t i = 1; i < trace.points.size(); ++i) {
      if (joints.size() == max_segments)
        break;
      points.insert(points.end(), {trace.points[i - 1], trace.points[i]});
      joints.push_back({trace.points[i - 1], trace.points[i], trace.joint.value_or(1)});
    }
  for (const Domain& domain : domains(points)) {
    cut(domain, joints);
    for (const char* snap : {"1", "1e300"})
      attempt([&] {
        cut(domain,
            geometry::prolonged(joints, number(snap), {}, domain.outline).traces);
      });
  }
}

void use_points(std::string_view text) {
  const exchange::PointFile file = exchange::read_points(text);
  exchange::format(file.messages, "fuzz", file.form, text);
  if (has_errors(file.messages))
    return;
  require(!file.points.empty());
  geometry::VoronoiRequest request;
  for (const DecimalPoint& point : file.points)
    if (request.points.size() < max_points)
      request.points.emplace_back(point.x.value(), point.y.value());
  for (const Domain& domain : domains(file.points))
    for (request.lloyd = 0; request.lloyd < 2; ++request.lloyd)
      attempt(
          [&] { cut(domain, geometry::voronoi_cells(request, domain.outline).edges); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  use_traces(text);
  use_points(text);
  return 0;
}
