#include "post/figure/sides.hpp"

#include <algorithm>
#include <utility>

#include "draw/joint_colours.hpp"
#include "post/read/joint_faces.hpp"

namespace blocks::post {

using namespace draw;

namespace {

/// Draws the sides for which wanted(block, side) is true. A path of many lines is slow,
/// so it is stroked in parts.
template <class Wanted>
void draw_sides(Pen& pen, const Half& half, const Frame& frame, const Wanted& wanted,
                double width, const Colour& colour, double alpha = 1.0) {
  constexpr int max = 64;
  int count = 0;
  for (std::size_t b = 0; b < frame.outlines.size(); ++b) {
    const auto& outline = frame.outlines[b];
    for (std::size_t k = 0; k < outline.size(); ++k) {
      if (!wanted(b, k))
        continue;
      Eigen::Vector2d from = outline[k], to = outline[(k + 1) % outline.size()];
      // Two blocks share a side, so its dashes must begin at the same end.
      if (to.x() < from.x() || (to.x() == from.x() && to.y() < from.y()))
        std::swap(from, to);
      if (half.trace(pen.cairo(), from, to) && ++count % max == 0)
        pen.stroke(width, colour, alpha);
    }
  }
  pen.stroke(width, colour, alpha);
}

void draw_outlines(Pen& pen, const Half& half, const Frame& frame, double width,
                   const Colour& colour) {
  for (const auto& outline : frame.outlines) {
    for (std::size_t k = 0; k < outline.size(); ++k)
      half.trace(pen.cairo(), outline[k], outline[(k + 1) % outline.size()]);
    pen.stroke(width, colour);
  }
}

/// Draws a side whose colours change from one end to the other.
void draw_shaded(Pen& pen, const Half& half, const ValuedSide& side,
                 const ValueRange& range, const ColourMap& map) {
  if (!half.trace(pen.cairo(), side.ends[0], side.ends[1]))
    return;
  const Eigen::Vector2d a = half.at(side.ends[0]), b = half.at(side.ends[1]);
  cairo_pattern_t* shades = cairo_pattern_create_linear(a.x(), a.y(), b.x(), b.y());
  constexpr int steps = 8;
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const Colour c =
        map.at(range.place(side.values[0] + part * (side.values[1] - side.values[0])));
    cairo_pattern_add_color_stop_rgb(shades, part, c.r, c.g, c.b);
  }
  cairo_set_source(pen.cairo(), shades);
  cairo_stroke(pen.cairo());
  cairo_pattern_destroy(shades);
}

}  // namespace

Colour slip_colour(double part) {
  constexpr Colour orange{0.96, 0.58, 0.11}, red{0.83, 0.15, 0.13},
      dark{0.38, 0.02, 0.14};
  const double s = std::clamp(part, 0.0, 1.0);
  return s < 0.5 ? mix(red, orange, 2.0 * s) : mix(dark, red, 2.0 * s - 1.0);
}

void set_bond_dashes(Pen& pen, Bond bond) {
  if (bond == Bond::weakened)
    pen.dashes({5, 3});
  else
    pen.dashes({});
}

void draw_joint_sides(Pen& pen, const Half& half, const Picture& picture,
                      const FigureScales& scales) {
  const double width = scales.on_page(half.axes, 0.055, 0.7, 2.6);
  const auto draw = [&](int id, double thick, const Colour& colour) {
    const auto& joints = picture.now.joints;
    const auto has_id = [&](std::size_t b, std::size_t k) {
      return (joints.empty() ? 0 : joints[b][k]) == id;
    };
    draw_sides(pen, half, picture.now, has_id, thick, colour);
  };
  draw(0, std::min(0.4 * width, 0.8), no_joint_colour);
  for (const int id : scales.joints) {
    set_joint_dashes(pen, id);
    draw(id, width, joint_colour(id));
  }
  pen.dashes({});
}

void draw_bond_sides(Pen& pen, const Half& half, const Picture& picture,
                     const FigureScales& scales) {
  const double width = scales.on_page(half.axes, 0.06, 0.9, 3.4);
  pen.dashes({});
  draw_outlines(pen, half, picture.now, std::min(0.4 * width, 0.8), no_joint_colour);
  cairo_set_line_cap(pen.cairo(), CAIRO_LINE_CAP_ROUND);
  for (const FacePart& part : face_parts(picture.now, picture.contacts)) {
    const bool failed = part.bond == Bond::failed || part.bond == Bond::weakened;
    const double share = scales.slip > 0.0 ? part.slip / scales.slip : 0.0;
    set_bond_dashes(pen, part.bond);
    half.trace(pen.cairo(), part.from, part.to);
    pen.stroke(width, failed ? slip_colour(share) : bonded_colour);
  }
  cairo_set_line_cap(pen.cairo(), CAIRO_LINE_CAP_BUTT);
  pen.dashes({});
}

void draw_crack_faces(Pen& pen, const Half& half, const Picture& picture,
                      const FigureScales& scales) {
  const double width = scales.on_page(half.axes, 0.05, 1.0, 2.6);
  const auto of_crack = [&](std::size_t b, std::size_t k) {
    return picture.cracked->face(static_cast<int>(b), k) != 0;
  };
  cairo_set_line_cap(pen.cairo(), CAIRO_LINE_CAP_ROUND);
  draw_sides(pen, half, picture.now, of_crack, width + 1.4, white, 0.8);
  draw_sides(pen, half, picture.now, of_crack, width, crack_colour);
  cairo_set_line_cap(pen.cairo(), CAIRO_LINE_CAP_BUTT);
}

void draw_face_sides(Pen& pen, const Half& half, const Picture& picture,
                     const FigureScales& scales, const FigureOptions& options) {
  const double width = scales.on_page(half.axes, 0.1, 2.2, 5.0);
  const ColourMap map =
      map_of(options, face_quantity(options.colour).zero, scales.colours);
  std::vector<ValuedSide> sides =
      valued_sides(options.colour, picture, half.mirror_x.has_value());
  std::stable_sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) {
    return a.values.cwiseAbs().maxCoeff() < b.values.cwiseAbs().maxCoeff();
  });
  cairo_set_line_width(pen.cairo(), width);
  for (const ValuedSide& side : sides)
    draw_shaded(pen, half, side, scales.colours, map);
  draw_outlines(pen, half, picture.now, std::min(0.15 * width, 0.6), muted);
}

Quantity face_quantity(const std::string& name) {
  if (name == "water_pressure")
    return {"water pressure", {-1, 1, -2, "Pa", ""}, {}, Zero::lowest};
  const bool is_opening = name == "opening";
  return {is_opening ? "opening" : "shear displacement, dextral positive",
          {1, 0, 0, "m", ""},
          {},
          Zero::middle};
}

std::vector<ValuedSide> valued_sides(const std::string& name, const Picture& picture,
                                     bool mirrored) {
  std::vector<ValuedSide> sides;
  if (name != "water_pressure") {
    for (const FaceMotion& motion :
         face_motions(picture.now, picture.first, picture.cracked))
      for (const auto& ends : {motion.own, motion.other})
        sides.push_back(
            {ends, name == "opening"
                       ? motion.opening
                       : Eigen::Vector2d((mirrored ? -1.0 : 1.0) * motion.shear)});
    return sides;
  }
  for (const WetSide& side : picture.now.wet_sides)
    // Joints with fixed blocks are sides of the others, too.
    if (picture.now.fixed[static_cast<std::size_t>(side.block)] == 0)
      sides.push_back({side.ends, side.pressure});
  return sides;
}

const char* no_laws_text() {
  return "no contact has the law of a joint at the times drawn\n  hint: the cards "
         "JOINT "
         "and JPAIR give joints a law; results of older versions have none";
}

std::string no_faces_text(const std::string& name) {
  if (name == "water_pressure")
    return "no water presses on a side at the times drawn\n  hint: WATER gives a water "
           "table, JWATER the pressure in joints";
  return "no two blocks have a common face at the times drawn\n  hint: these are faces "
         "that are closed in the first frame of the results";
}

}  // namespace blocks::post
