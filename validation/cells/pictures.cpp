#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "draw/axes.hpp"
#include "draw/page_file.hpp"
#include "draw/pen.hpp"
#include "validation/cells/figures.hpp"
#include "validation/cells/networks.hpp"

namespace blocks::validation {
namespace {

using namespace geometry;
using draw::Colour;
using std::numbers::pi;

/// The classes of a colouring: class k is below limits[k].
struct Classes {
  std::string title;
  std::vector<double> limits;
  std::vector<std::string> names;
  double (*value)(double area, int sides);
  double darkest = 0.9;  ///< place of the last class on the colour map

  std::size_t of(double area, int sides) const {
    const auto found =
        std::upper_bound(limits.begin(), limits.end(), value(area, sides));
    return static_cast<std::size_t>(found - limits.begin());
  }
  Colour colour(std::size_t k) const {
    const double s = static_cast<double>(k) / static_cast<double>(names.size() - 1);
    return draw::colour_map("ylgnbu").at(0.06 + (darkest - 0.06) * s);
  }
};

Classes by_sides(int first, int last) {
  Classes result{"sides", {}, {}, [](double, int sides) { return sides + 0.5; }};
  for (int n = first; n <= last; ++n) {
    if (n < last)
      result.limits.push_back(n + 1);
    result.names.push_back(std::to_string(n) + (n < last ? "" : " or more"));
  }
  return result;
}

Classes by_area(const std::string& mean = "its exact mean", double darkest = 0.9) {
  return {"area in units of " + mean,
          {0.125, 0.25, 0.5, 1, 2, 4},
          {"below 1/8", "1/8 to 1/4", "1/4 to 1/2", "1/2 to 1", "1 to 2", "2 to 4",
           "above 4"},
          [](double area, int) { return area; },
          darkest};
}

struct Picture {
  std::string file, title, subtitle;
  CutRequest request;
  double mean_area;  ///< [L^2] unit of areas; 0: that of the blocks of the picture
  Classes classes;
};

constexpr double width = 24.0, height = 14.0;  ///< [L] of the outline
constexpr double page = 1200, head = 84, foot = 66, left = 24;

class NetworkDrawing {
 public:
  NetworkDrawing(cairo_t* cairo, const Picture& picture, const CutResult& result,
                 const draw::Axes& axes)
      : cairo_(cairo), pen_(cairo, draw::PageSize::on_screen(page)), picture_(picture),
        result_(result), axes_(axes) {}

  void draw() {
    pen_.clear();
    pen_.text(picture_.title, left, 34, 21, draw::ink, 0, 1);
    pen_.text(picture_.subtitle, left, 62, 15, draw::muted, 0, 1, page - 2 * left);
    for (const CutBlock& block : result_.blocks)
      fill(block);
    draw_pruned();
    for (const CutBlock& block : result_.blocks) {
      trace(block.corners);
      pen_.stroke(1.3, draw::ink);
    }
    trace(result_.mesh.outline);
    pen_.stroke(2.4, draw::ink);
    draw_legend();
  }

 private:
  static constexpr Colour pruned{0.80, 0.33, 0.00};

  Vec2 at(int v) const {
    const Vec2& p = result_.mesh.vertices[static_cast<std::size_t>(v)];
    return {axes_.x(p.x()), axes_.y(p.y())};
  }
  void trace(const std::vector<int>& loop) {
    cairo_new_path(cairo_);
    for (const int v : loop)
      cairo_line_to(cairo_, at(v).x(), at(v).y());
    cairo_close_path(cairo_);
  }
  void fill(const CutBlock& block) {
    double twice = 0.0;
    for (std::size_t i = 0; i < block.corners.size(); ++i)
      twice += cross(at(block.corners[i]),
                     at(block.corners[(i + 1) % block.corners.size()]));
    const double mean =
        picture_.mean_area > 0.0
            ? picture_.mean_area
            : width * height / static_cast<double>(result_.blocks.size());
    const double area = twice / 2 / (axes_.scale() * axes_.scale()) / mean;
    trace(block.corners);
    pen_.colour(picture_.classes.colour(
        picture_.classes.of(area, static_cast<int>(block.corners.size()))));
    cairo_fill(cairo_);
  }
  /// Draws all joints. The sides of the blocks cover the others later.
  void draw_pruned() {
    if (result_.report.pruned_edges == 0)
      return;
    cairo_save(cairo_);
    trace(result_.mesh.outline);
    cairo_clip(cairo_);
    for (const JointSegment& joint : picture_.request.joints) {
      const Vec2 &a = joint.from.nearest(), &b = joint.to.nearest();
      pen_.line(axes_.x(a.x()), axes_.y(a.y()), axes_.x(b.x()), axes_.y(b.y()), 1.3,
                pruned);
    }
    cairo_restore(cairo_);
  }
  void draw_legend() {
    const double y = axes_.bottom() + 36;
    double x = left;
    pen_.text(picture_.classes.title + ":", x, y, 14, draw::ink, 0, 0.5);
    x += pen_.width(picture_.classes.title + ":", 14) + 16;
    for (std::size_t k = 0; k < picture_.classes.names.size(); ++k) {
      cairo_rectangle(cairo_, x, y - 8, 22, 16);
      pen_.fill_and_stroke(picture_.classes.colour(k), 1, draw::ink);
      pen_.text(picture_.classes.names[k], x + 29, y, 14, draw::ink, 0, 0.5);
      x += 29 + pen_.width(picture_.classes.names[k], 14) + 18;
    }
    if (result_.report.pruned_edges == 0)
      return;
    pen_.line(x, y, x + 26, y, 2, pruned);
    pen_.text("pruned", x + 33, y, 14, draw::ink, 0, 0.5);
  }

  cairo_t* cairo_;
  draw::Pen pen_;
  const Picture& picture_;
  const CutResult& result_;
  const draw::Axes& axes_;
};

void draw(const Picture& picture, const std::string& folder) {
  const CutResult result = cut_outline(picture.request);
  const draw::Axes axes({0.0, width, 0.0, height}, left, head, page - 2 * left);
  draw::write_page(
      folder + "/" + picture.file, page, axes.bottom() + foot,
      [&](cairo_t* cairo) { NetworkDrawing(cairo, picture, result, axes).draw(); });
}

}  // namespace

void draw_pictures(const std::string& folder) {
  constexpr double tau = 2.2;
  const auto outline = rectangle(width, height);
  draw({"poisson_lines.png", "Poisson lines", "length per area tau = 2.2",
        poisson_lines(outline, tau, 5), pi / (tau * tau), by_sides(3, 8)},
       folder);
  std::vector<JointSet> sets = {distant_set(10.0, 1.0, 3, 1),
                                distant_set(70.0, 1.0, 3, 2)};
  for (JointSet& set : sets)
    set.law = SpacingLaw::negexp;
  draw({"negexp.png", "Two NEGEXP sets",
        "mean spacings 1 and 1, at an angle of 60 degrees", request(outline, sets),
        1.0 / std::sin(pi / 3), by_area()},
       folder);
  sets = {distant_set(15.0, 1.0, 3, 1), distant_set(105.0, 1.0, 3, 2)};
  for (JointSet& set : sets)
    set.spacing.deviation = decimal(0.5);
  draw({"uniform.png", "Two UNIFORM sets",
        "spacings 1 with half range 0.5, at right angles", request(outline, sets), 1.0,
        by_area()},
       folder);
  sets = {distant_set(8.0, 1.2, 3, 1), distant_set(98.0, 0.7, 3, 2)};
  sets[0].law = SpacingLaw::negexp;
  sets[1].trace.mean = decimal(3.0);
  sets[1].trace.deviation = decimal(1.0);
  sets[1].gap.mean = decimal(2.0);
  sets[1].gap.deviation = decimal(1.0);
  sets[1].spacing.deviation = decimal(0.3);
  sets[1].dip.deviation = decimal(6.0);
  draw({"persistence.png", "Through-going joints and traces that end",
        "traces 3 with gaps 2 across a NEGEXP set; ends that separate no blocks are "
        "pruned",
        request(outline, sets), 0.0, by_area("the mean of these blocks", 0.6)},
       folder);
  draw({"voronoi.png", "Poisson Voronoi cells", "2 points per area",
        poisson_voronoi(outline, 2.0 * width * height, 4), 0.5, by_sides(3, 9)},
       folder);
}

}  // namespace blocks::validation
