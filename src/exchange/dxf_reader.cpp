#include "exchange/dxf_reader.hpp"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <istream>
#include <map>
#include <numbers>
#include <streambuf>

#include "exchange/chords.hpp"
#include "exchange/dxf_groups.hpp"
#include "exchange/dxf_kinds.hpp"
#include "exchange/dxf_units.hpp"

namespace blocks::exchange {
namespace {

using geometry::Vec2;

/// A stream over a part of the text.
class TextStream : private std::streambuf, public std::istream {
 public:
  TextStream() : std::istream(static_cast<std::streambuf*>(this)) {}
  void show(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // never written to
    setg(begin, begin, begin + text.size());
    clear();
  }
};

/// What the library tells about one entity.
class Entity : public DL_CreationAdapter {
 public:
  struct Vertex {
    Vec2 place;
    double z, bulge;
  };
  std::vector<Vertex> vertices;  ///< of lines, and control or fit points
  Spline spline;
  DL_ArcData arc{0, 0, 0, 0, 0, 0};
  DL_EllipseData ellipse{0, 0, 0, 0, 0, 0, 0, 0, 0};
  std::vector<Vec2> fit_points;
  unsigned flags = 0;
  std::string layer;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();

  void clear() {
    vertices.clear();
    spline = {};
    fit_points.clear();
    flags = 0;
  }

  void addLine(const DL_LineData& d) override {
    begin(0);
    vertices = {{{d.x1, d.y1}, d.z1, 0.0}, {{d.x2, d.y2}, d.z2, 0.0}};
  }
  void addPolyline(const DL_PolylineData& d) override { begin(d.flags); }
  void addVertex(const DL_VertexData& d) override {
    vertices.push_back({{d.x, d.y}, d.z, d.bulge});
  }
  void addArc(const DL_ArcData& d) override {
    begin(0);
    arc = d;
  }
  void addCircle(const DL_CircleData& d) override {
    begin(0);
    arc = {d.cx, d.cy, d.cz, d.radius, 0.0, 360.0};
  }
  void addEllipse(const DL_EllipseData& d) override {
    begin(0);
    ellipse = d;
  }
  void addSpline(const DL_SplineData& d) override {
    begin(d.flags);
    spline.degree = static_cast<int>(d.degree);
  }
  void addControlPoint(const DL_ControlPointData& d) override {
    spline.points.emplace_back(d.x, d.y);
    spline.weights.push_back(d.w);
    vertices.push_back({{d.x, d.y}, d.z, 0.0});
  }
  void addFitPoint(const DL_FitPointData& d) override {
    fit_points.emplace_back(d.x, d.y);
  }
  void addKnot(const DL_KnotData& d) override { spline.knots.push_back(d.k); }

 private:
  void begin(unsigned with) {
    flags = with;
    layer = getAttributes().getLayer();
    const double* direction = getExtrusion()->getDirection();
    normal = {direction[0], direction[1], direction[2]};
  }
};

class DrawingReader {
 public:
  explicit DrawingReader(std::string_view text) : text_(text) {}

  DxfDrawing read() {
    DxfGroups groups = find_dxf_entities(text_);
    drawing_.messages = std::move(groups.messages);
    drawing_.unit = dxf_unit(groups.unit);
    if (has_errors(drawing_.messages))
      return std::move(drawing_);  // dxflib takes counts and numbers on trust
    for (const DxfEntity& entity : groups.entities)
      if (!entity.is_on_paper)
        read(entity);
    tell_heights();
    tell_empty();
    tell_others();
    return std::move(drawing_);
  }

 private:
  struct Count {
    std::size_t n = 0, first = 0;
  };

  std::string_view text_;
  DxfDrawing drawing_;
  TextStream stream_;
  DL_Dxf library_;
  Entity entity_;
  std::map<std::string, std::size_t> layers_;
  std::map<std::string_view, Count> others_;  // kinds that are not read
  Count heights_, empty_;

  void error(const DxfEntity& at, const std::string& text, const std::string& hint) {
    drawing_.messages.push_back(
        {true, at.at, fmt::format("{}: {}", at.kind, text), hint, at.kind.size()});
  }

  void read(const DxfEntity& found) {
    if (is_dxf_solid(found.kind))
      return error(found, "a body or surface in space cannot be a line of a plane",
                   "draw a section through it, and leave the body out");
    if (!is_dxf_line(found.kind)) {
      Count& count = others_[found.kind];
      if (count.n++ == 0)
        count.first = found.at;
      return;
    }
    entity_.clear();
    stream_.show(found.groups);
    library_.in(stream_, &entity_);
    if (!is_in_plane(found))
      return;
    DxfLine line;
    line.at = found.at;
    if (found.kind == "SPLINE")
      take_spline(found, line);
    else if (found.kind == "ELLIPSE")
      take_ellipse(line);
    else if (found.kind == "ARC" || found.kind == "CIRCLE")
      take_arc(line);
    else
      take_polyline(found, line);
    add(found, std::move(line));
  }

  /// Tests whether the entity is drawn in the xy plane, from above or from below.
  bool is_in_plane(const DxfEntity& found) {
    const bool is_polyline = found.kind == "POLYLINE";
    if (is_polyline && (entity_.flags & (16U | 64U)) != 0) {
      error(found, "a mesh in space cannot be a line of a plane",
            "draw a section through it, and leave the mesh out");
      return false;
    }
    if (is_polyline && (entity_.flags & 4U) != 0) {
      error(found, "a polyline with a fitted spline", "convert it to a SPLINE");
      return false;
    }
    const bool is_in_space = found.kind == "LINE" || found.kind == "SPLINE" ||
                             (is_polyline && (entity_.flags & 8U) != 0);
    if (!is_in_space &&
        entity_.normal.head<2>().norm() > 1e-9 * std::abs(entity_.normal.z())) {
      error(found, "it is not drawn in the xy plane",
            "project the drawing onto the xy plane");
      return false;
    }
    for (const Entity::Vertex& vertex : entity_.vertices)
      if (vertex.z != entity_.vertices.front().z) {
        if (heights_.n++ == 0)
          heights_.first = found.at;
        break;
      }
    return true;
  }

  bool is_from_below() const { return entity_.normal.z() < 0.0; }

  void take_polyline(const DxfEntity& found, DxfLine& line) {
    line.is_closed = (entity_.flags & 1U) != 0;
    const auto& vertices = entity_.vertices;
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      const bool is_last = i + 1 == n;
      if (i == 0)
        line.points.push_back(vertices[0].place);
      if (is_last && !line.is_closed)
        break;
      const Vec2 &p = vertices[i].place, &q = vertices[is_last ? 0 : i + 1].place;
      const double bulge = vertices[i].bulge;
      if (bulge == 0.0) {
        line.points.push_back(q);
        continue;
      }
      const double radius =
          0.25 * (q - p).norm() * (std::abs(bulge) + 1.0 / std::abs(bulge));
      ChordError error{chord_part * 2.0 * std::numbers::sqrt2 * radius, 0.0};
      const std::size_t before = line.points.size();
      add_arc(p, q, bulge, error, line.points);
      count_curve(line.points.size() - before, error.largest);
    }
    if (line.is_closed && n > 0)
      line.points.pop_back();
    // Lines and polylines in space have coordinates of the world.
    if (is_from_below() && (entity_.flags & 8U) == 0 && found.kind != "LINE")
      mirror(line);
  }

  void take_arc(DxfLine& line) {
    const DL_ArcData& arc = entity_.arc;
    double turn = std::fmod(arc.angle2 - arc.angle1, 360.0);
    if (turn <= 0.0)
      turn += 360.0;
    add_round(arc.angle1, turn, std::abs(arc.radius), line, [&arc](const Vec2& p) {
      return Vec2(Vec2(arc.cx, arc.cy) + arc.radius * p);
    });
    if (is_from_below())
      mirror(line);
  }

  void take_ellipse(DxfLine& line) {
    const DL_EllipseData& ellipse = entity_.ellipse;
    constexpr double degrees = 180.0 / std::numbers::pi;
    double turn = std::fmod(degrees * (ellipse.angle2 - ellipse.angle1), 360.0);
    if (turn <= 1e-6)  // a whole turn in radians is not exactly one in degrees
      turn += 360.0;
    if (turn > 360.0 - 1e-6)
      turn = 360.0;
    const Vec2 centre(ellipse.cx, ellipse.cy), major(ellipse.mx, ellipse.my);
    const Vec2 minor =
        ellipse.ratio * (is_from_below() ? -1.0 : 1.0) * Vec2(-major.y(), major.x());
    add_round(
        degrees * ellipse.angle1, turn,
        major.norm() * std::max(1.0, std::abs(ellipse.ratio)), line,
        [&](const Vec2& p) { return Vec2(centre + p.x() * major + p.y() * minor); });
  }

  /// Adds an image of an arc of the unit circle. scale: the largest factor by which
  /// the image stretches a length. A whole turn is a closed line.
  template <class Image>
  void add_round(double from, double turn, double scale, DxfLine& line,
                 const Image& image) {
    ChordError error{chord_part * 2.0 * std::numbers::sqrt2, 0.0};
    for (const Vec2& p : unit_arc(from, turn, error))
      line.points.push_back(image(p));
    count_curve(line.points.size() - 1, error.largest * scale);
    line.is_closed = turn == 360.0;
    if (line.is_closed)
      line.points.pop_back();
  }

  void take_spline(const DxfEntity& found, DxfLine& line) {
    const Spline& spline = entity_.spline;
    if (spline.points.empty() && entity_.fit_points.size() > 1)
      return error(found, "a spline without control points",
                   "save the drawing as R2000 or later, or convert the spline to a "
                   "polyline");
    if (const std::string fault = fault_of(spline); !fault.empty())
      return error(found, fault, "the file is damaged: write it again");
    Eigen::AlignedBox2d box;
    for (const Vec2& point : spline.points)
      box.extend(point);
    ChordError error{chord_part * box.diagonal().norm(), 0.0};
    line.points = spline_chords(spline, error);
    count_curve(line.points.size() - 1, error.largest);
    line.is_closed = (entity_.flags & 1U) != 0 && line.points.size() > 3;
    if (line.is_closed)
      line.points.pop_back();  // the first one, up to rounding
  }

  void count_curve(std::size_t chords, double off) {
    ++drawing_.curves;
    drawing_.chords += chords;
    drawing_.chord_error = std::max(drawing_.chord_error, off);
  }

  static void mirror(DxfLine& line) {
    for (Vec2& point : line.points)
      point.x() = -point.x();
  }

  void add(const DxfEntity& found, DxfLine line) {
    if (line.points.empty())
      return;
    auto& points = line.points;
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (line.is_closed && points.size() > 1 && points.front() == points.back())
      points.pop_back();
    if (points.size() < 2) {
      if (empty_.n++ == 0)
        empty_.first = found.at;
      return;
    }
    if (!std::all_of(line.points.begin(), line.points.end(),
                     [](const Vec2& p) { return p.allFinite(); }))
      return error(found, "a point is outside the range of numbers",
                   "choose another unit of length");
    const std::string name = entity_.layer.empty() ? "0" : entity_.layer;
    const auto [layer, is_new] = layers_.emplace(name, layers_.size());
    if (is_new)
      drawing_.layers.push_back(name);
    line.layer = layer->second;
    drawing_.lines.push_back(std::move(line));
  }

  void warn(std::size_t at, const std::string& text, const std::string& hint) {
    drawing_.messages.push_back({false, at, text, hint});
  }

  void tell_heights() {
    if (heights_.n > 0)
      warn(heights_.first,
           fmt::format("{} line{} through different heights", heights_.n,
                       heights_.n == 1 ? " runs" : "s run"),
           "only x and y are read");
  }

  void tell_empty() {
    if (empty_.n > 0)
      warn(empty_.first,
           fmt::format("{} of length 0 {} left out",
                       empty_.n == 1 ? "a line" : fmt::format("{} lines", empty_.n),
                       empty_.n == 1 ? "is" : "are"),
           "");
  }

  void tell_others() {
    if (others_.empty())
      return;
    std::vector<std::string> kinds;
    std::size_t first = text_.size();
    for (const auto& [kind, count] : others_) {
      kinds.push_back(fmt::format("{} {}", count.n, kind.substr(0, 40)));
      first = std::min(first, count.first);
    }
    warn(first, fmt::format("not read: {}", fmt::join(kinds, ", ")),
         others_.count("INSERT") > 0
             ? "explode block references (INSERT) that contain joints"
             : "only lines and curves are read");
  }
};

}  // namespace

DxfDrawing read_drawing(std::string_view text) { return DrawingReader(text).read(); }

std::string describe_chords(const DxfDrawing& drawing) {
  return drawing.curves == 0
             ? std::string()
             : fmt::format("{} curve{} as {} chords, off by {:.2g} at most",
                           drawing.curves, drawing.curves == 1 ? "" : "s",
                           drawing.chords, drawing.chord_error);
}

}  // namespace blocks::exchange
