#include "post/figure/scene_drawing.hpp"

#include <algorithm>
#include <cmath>

#include "post/figure/arrows.hpp"
#include "post/figure/sides.hpp"
#include "post/figure/symbols.hpp"
#include "post/read/force_network.hpp"
#include "post/read/frame_quantity.hpp"
#include "post/read/piece_families.hpp"

namespace blocks::post {

using namespace draw;

namespace {

using Outline = std::vector<Eigen::Vector2d>;

/// Draws one picture, and stores the data that its parts share.
class SceneDrawing {
 public:
  SceneDrawing(Pen& pen, const Axes& axes, const Picture& picture,
               const FigureScales& scales, const FigureOptions& options)
      : pen_(pen), cairo_(pen.cairo()), axes_(axes), now_(picture.now),
        picture_(picture), scales_(scales), options_(options) {
    if (!options.shows_quantity())
      return;
    shown_ = quantity(options.colour, now_, picture.first, picture.contacts);
    if (options.mirror)
      in_mirror_ = in_mirror(options.colour, shown_.values, options.mirror_x);
  }

  void draw() {
    cairo_save(cairo_);
    cairo_rectangle(cairo_, axes_.left, axes_.top, axes_.width, axes_.height);
    pen_.colour(white);
    cairo_fill_preserve(cairo_);
    cairo_clip(cairo_);
    for (const bool mirrored : {true, false}) {
      if (mirrored && !options_.mirror)
        continue;
      turn(mirrored);
      if (options_.original)
        original();
      for (std::size_t b = 0; b < now_.outlines.size(); ++b)
        if (in_view(now_.outlines[b]))
          block(b);
      if (options_.shows_joints())
        draw_joint_sides(pen_, half_, picture_, scales_);
      if (options_.shows_bonds())
        draw_bond_sides(pen_, half_, picture_, scales_);
      if (options_.shows_faces())
        draw_face_sides(pen_, half_, picture_, scales_, options_);
      if (options_.shows_cracks() && picture_.cracked != nullptr)
        draw_crack_faces(pen_, half_, picture_, scales_);
      if (options_.forces)
        forces();
      if (!options_.arrows.empty())
        draw_arrows(pen_, half_, picture_, scales_, options_);
      if (!mirrored)
        numbers();
    }
    for (const bool mirrored : {true, false})
      if (!mirrored || options_.mirror) {
        turn(mirrored);
        water_table();
      }
    if (options_.mirror)
      centre_line();
    else
      planes();
    marks();
    cairo_restore(cairo_);
  }

 private:
  using Box = Eigen::AlignedBox2d;

  /// Goes on with the mirror image, or with the model itself.
  void turn(bool mirrored) {
    half_.mirror_x = mirrored ? std::optional(options_.mirror_x) : std::nullopt;
  }
  void trace(const Outline& line) {
    for (const Eigen::Vector2d& p : line) {
      const Eigen::Vector2d at = half_.at(p);
      cairo_line_to(cairo_, at.x(), at.y());
    }
  }
  void path(const Outline& outline) {
    trace(outline);
    cairo_close_path(cairo_);
  }
  bool in_view(const Outline& outline) const {
    const Box plot(Eigen::Vector2d(axes_.left, axes_.top),
                   Eigen::Vector2d(axes_.right(), axes_.bottom()));
    return half_.box(outline).intersects(plot);
  }
  /// Returns the smaller side of the bounding box of a block on the page.
  double size_on_page(const Outline& outline) const {
    Box box;
    for (const Eigen::Vector2d& p : outline)
      box.extend(p);
    return box.sizes().minCoeff() * axes_.scale();
  }

  /// Returns the fill colour of a block; material colours are pale under a network of
  /// forces and between joints.
  Colour fill_of(std::size_t b) const {
    if (!options_.shows_quantity())
      return colour_of_material(now_.material[b], options_);
    const double value =
        (half_.mirror_x ? in_mirror_ : shown_.values)[static_cast<Eigen::Index>(b)];
    const ValueRange& range = scales_.colours;
    return map_of(options_, shown_.zero, range).at(range.place(value));
  }

  void block(std::size_t b) {
    const Colour fill = fill_of(b);
    path(now_.outlines[b]);
    pen_.colour(fill);
    cairo_fill_preserve(cairo_);
    if (now_.fixed[b] != 0)
      hatch(pen_, fill);
    if (options_.shows_sides()) {  // the sides are drawn on top
      cairo_new_path(cairo_);
      return;
    }
    const double width = std::clamp(0.03 * size_on_page(now_.outlines[b]), 0.25, 1.1);
    pen_.stroke(width, outline_on(fill, options_.forces), 0.9);
  }

  void original() {
    pen_.dashes({4, 3});
    for (const Outline& outline : picture_.original_frame().outlines)
      if (in_view(outline)) {
        path(outline);
        pen_.stroke(0.7, faint);
      }
    pen_.dashes({});
  }

  /// Draws a line from centroid to centroid through the contact for each pair of
  /// touching blocks; its width is proportional to the force. A rim, dark beside a pale
  /// line and white beside a dark one, shows it on blocks of any colour.
  void forces() {
    if (!(scales_.force > 0.0))
      return;
    const double full = scales_.on_page(axes_, 0.3, 2.5, 14.0);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
    const auto links = force_network(picture_.contacts);
    for (const bool rim : {true, false})
      force_lines(links, full, rim);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_BUTT);
  }

  void force_lines(const std::vector<ForceLink>& links, double full, bool rim) {
    for (const ForceLink& link : links) {
      const double part = link.force.norm() / scales_.force;
      const double width = full * std::min(part, 1.5);
      if (width < 0.15)
        continue;
      for (const int b : {link.first, link.second}) {
        if (b < 0 || b >= now_.size() || now_.fixed[static_cast<std::size_t>(b)] != 0)
          continue;
        const Eigen::Vector2d from = half_.at(link.point),
                              to = half_.at(now_.centroid.col(b));
        cairo_move_to(cairo_, from.x(), from.y());
        cairo_line_to(cairo_, to.x(), to.y());
      }
      const Colour line = intensity(part);
      if (rim)
        pen_.stroke(width + std::min(1.4, 0.3 + 0.7 * width), rim_of_line(line));
      else
        pen_.stroke(width, line);
    }
  }

  void numbers() {
    for (std::size_t b = 0; b < now_.outlines.size(); ++b) {
      const Outline& outline = now_.outlines[b];
      if (!(options_.numbers || options_.corners) || !in_view(outline))
        continue;
      const double size = size_on_page(outline);
      const Eigen::Vector2d at =
          half_.at(now_.centroid.col(static_cast<Eigen::Index>(b)));
      const Colour ground = fill_of(b), letters = is_dark(ground) ? white : ink;
      const bool fits = size > 1.3 * options_.page.min_text;
      if (options_.numbers && fits)
        pen_.label(std::to_string(now_.number[b]), at.x(), at.y(),
                   std::clamp(0.42 * size, 5.0, 16.0), letters, ground);
      if (options_.corners && size > 3.0 * options_.page.min_text)
        corner_numbers(outline, std::clamp(0.2 * size, 3.0, 12.0), letters, ground);
    }
  }

  /// Draws the corner numbers inside the block, on the bisectors of its corners.
  void corner_numbers(const Outline& outline, double letter, const Colour& c,
                      const Colour& ground) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector2d& at = outline[i];
      const Eigen::Vector2d inwards = (outline[(i + 1) % n] - at).normalized() +
                                      (outline[(i + n - 1) % n] - at).normalized();
      const Eigen::Vector2d step = 1.2 * letter * inwards.normalized();
      const Eigen::Vector2d corner = half_.at(at);
      pen_.label(std::to_string(i + 1),
                 corner.x() + (half_.mirror_x ? -1 : 1) * step.x(),
                 corner.y() - step.y(), letter, c, ground);
    }
  }

  /// Draws a frame inside the current path, which is that of the outline.
  void frame_inside(const Outline& outline, const Colour& c) {
    constexpr double widest = 2.0, share_of_block = 0.2;
    const double width = std::min(widest, share_of_block * size_on_page(outline));
    cairo_save(cairo_);
    cairo_clip_preserve(cairo_);
    pen_.stroke(2.0 * width, c);  // the outer half is clipped
    cairo_restore(cairo_);
  }

  /// Draws a frame inside the blocks of a mark, which keep the colour of their
  /// material. Fills the area where two of them overlap, and draws a ring around the
  /// place.
  void marks() {
    for (const Mark& mark : options_.marks) {
      const Colour c = mark_colour(mark.kind);
      cairo_save(cairo_);
      for (const int b : mark.blocks) {
        const Outline& outline = now_.outlines[static_cast<std::size_t>(b)];
        path(outline);
        if (mark.kind == Mark::Kind::overlap)
          cairo_clip(cairo_);  // successive clips leave the common area
        else
          frame_inside(outline, c);
      }
      if (mark.kind == Mark::Kind::overlap) {
        pen_.colour(c, 0.85);
        cairo_paint(cairo_);
      }
      cairo_restore(cairo_);
    }
    for (const Mark& mark : options_.marks) {
      const Colour c = mark_colour(mark.kind);
      const Eigen::Vector2d at = half_.at(mark.place);
      trace_mark(cairo_, mark.kind, at.x(), at.y(), 9);
      cairo_path_t* ring = cairo_copy_path(cairo_);
      pen_.stroke(4.5, paper, 0.9);
      cairo_append_path(cairo_, ring);
      cairo_path_destroy(ring);
      pen_.stroke(2.2, c);
      if (!mark.label.empty())
        pen_.tag(mark.label, at.x() + 16, at.y() - 14, c);
    }
  }

  void planes() {
    const double reach = axes_.width + axes_.height;
    for (const PlaneLine& plane : options_.planes) {
      const Eigen::Vector2d middle(axes_.left + 0.5 * axes_.width,
                                   axes_.top + 0.5 * axes_.height);
      const Eigen::Vector2d a(axes_.x(plane.a.x()), axes_.y(plane.a.y()));
      const Eigen::Vector2d b(axes_.x(plane.b.x()), axes_.y(plane.b.y()));
      const Eigen::Vector2d along = (b - a).normalized();
      const Eigen::Vector2d nearest = a + along.dot(middle - a) * along;
      draw_plane(pen_, nearest - reach * along, nearest + reach * along);
    }
  }

  /// Returns the water table; of a picture with a mirror, what is on the side of the
  /// model.
  Outline table_of_model() const {
    Outline line;
    if (!options_.mirror)
      return now_.water_line;
    double sum = 0.0;  // tells on which side the model is
    for (const Outline& outline : now_.outlines)
      for (const Eigen::Vector2d& p : outline)
        sum += p.x() - options_.mirror_x;
    const auto is_here = [&](const Eigen::Vector2d& p) {
      return (p.x() - options_.mirror_x) * sum >= 0.0;
    };
    for (std::size_t k = 0; k < now_.water_line.size(); ++k) {
      const Eigen::Vector2d& p = now_.water_line[k];
      if (k > 0 && is_here(p) != is_here(now_.water_line[k - 1])) {
        const Eigen::Vector2d& q = now_.water_line[k - 1];
        line.emplace_back(q + (options_.mirror_x - q.x()) / (p.x() - q.x()) * (p - q));
      }
      if (is_here(p))
        line.push_back(p);
    }
    return line;
  }
  /// Draws the water table, with its sign at a twentieth of the width of the picture. A
  /// table that does not pass there has no sign.
  void water_table() {
    const Outline line = table_of_model();
    if (line.size() < 2)
      return;
    trace(line);
    pen_.stroke(3.2, paper, 0.8);
    trace(line);
    pen_.stroke(1.6, water_colour);
    constexpr double part = 0.05;
    const double x = axes_.left + part * axes_.width;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const Eigen::Vector2d a = half_.at(line[k]), b = half_.at(line[k + 1]);
      if (std::min(a.x(), b.x()) <= x && x < std::max(a.x(), b.x()))
        draw_water_sign(pen_, x,
                        a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y()));
    }
  }

  void centre_line() {
    pen_.dashes({14, 4, 3, 4});
    const double x = axes_.x(options_.mirror_x);
    pen_.line(x, axes_.top, x, axes_.bottom(), 1.2, ink, 0.8);
    pen_.dashes({});
  }

  Pen& pen_;
  cairo_t* cairo_;
  const Axes& axes_;
  const Frame& now_;
  const Picture& picture_;
  const FigureScales& scales_;
  const FigureOptions& options_;
  Quantity shown_;
  Eigen::VectorXd in_mirror_;       ///< the values of the mirrored half
  Half half_{axes_, std::nullopt};  ///< that is drawn
};

}  // namespace

void draw_scene(Pen& pen, const Axes& axes, const Picture& picture,
                const FigureScales& scales, const FigureOptions& options) {
  SceneDrawing(pen, axes, picture, scales, options).draw();
}

Colour colour_of_material(int material, const FigureOptions& options) {
  const auto chosen = options.material_colours.find(material);
  const Colour own = options.shows_families() && material == 0 ? whole_colour
                     : chosen == options.material_colours.end()
                         ? material_colour(material)
                         : chosen->second;
  const bool below_lines = options.forces || options.shows_sides();
  return below_lines ? mix(own, white, 0.3) : own;
}

}  // namespace blocks::post
