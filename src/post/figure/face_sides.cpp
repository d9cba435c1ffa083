#include "post/figure/face_sides.hpp"

#include <algorithm>
#include <utility>

#include "post/figure/half.hpp"

namespace blocks::post {

using namespace draw;

Quantity face_quantity(const std::string& name) {
  if (name == "water_pressure")
    return {"water pressure", {-1, 1, -2, "Pa", ""}, {}, Zero::lowest};
  const bool is_opening = name == "opening";
  return {is_opening ? "opening" : "shear displacement, dextral positive",
          {1, 0, 0, "m", ""},
          {},
          Zero::middle};
}

Eigen::Vector2d face_values(const std::string& name, const FaceMotion& motion,
                            bool mirrored) {
  if (name == "opening")
    return motion.opening;
  return mirrored ? Eigen::Vector2d(-motion.shear) : motion.shear;
}

std::vector<ValuedSide> valued_sides(const std::string& name, const Picture& picture,
                                     bool mirrored) {
  std::vector<ValuedSide> sides;
  if (name != "water_pressure") {
    for (const FaceMotion& motion :
         face_motions(picture.now, picture.first, picture.cracked))
      for (const auto& ends : {motion.own, motion.other})
        sides.push_back({ends, face_values(name, motion, mirrored)});
    return sides;
  }
  for (const WetSide& side : picture.now.wet_sides)
    // Joints with fixed blocks are sides of the others, too.
    if (picture.now.fixed[static_cast<std::size_t>(side.block)] == 0)
      sides.push_back({side.ends, side.pressure});
  return sides;
}

void draw_face_sides(Pen& pen, const Axes& axes, const Picture& picture,
                     const FigureScales& scales, const FigureOptions& options,
                     const std::optional<double>& mirror_x) {
  constexpr double share_of_block = 0.1, thinnest = 2.2, widest = 5.0;
  const double width =
      std::clamp(share_of_block * scales.block_size * axes.scale(), thinnest, widest);
  cairo_t* cairo = pen.cairo();
  const Half half{axes, mirror_x};
  const ColourMap map =
      map_of(options, face_quantity(options.colour).zero, scales.colours);
  std::vector<ValuedSide> sides =
      valued_sides(options.colour, picture, mirror_x.has_value());
  std::stable_sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) {
    return a.values.cwiseAbs().maxCoeff() < b.values.cwiseAbs().maxCoeff();
  });
  cairo_set_line_width(cairo, width);
  for (const auto& [ends, values] : sides) {
    if (!half.trace(cairo, ends[0], ends[1]))
      continue;
    const Eigen::Vector2d a = half.at(ends[0]), b = half.at(ends[1]);
    cairo_pattern_t* shades = cairo_pattern_create_linear(a.x(), a.y(), b.x(), b.y());
    constexpr int steps = 8;
    for (int i = 0; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps;
      const Colour c =
          map.at(scales.colours.place(values[0] + part * (values[1] - values[0])));
      cairo_pattern_add_color_stop_rgb(shades, part, c.r, c.g, c.b);
    }
    cairo_set_source(cairo, shades);
    cairo_stroke(cairo);
    cairo_pattern_destroy(shades);
  }
  for (const auto& outline : picture.now.outlines) {
    for (std::size_t k = 0; k < outline.size(); ++k)
      half.trace(cairo, outline[k], outline[(k + 1) % outline.size()]);
    pen.stroke(std::min(0.15 * width, 0.6), muted);
  }
}

std::string no_faces_text(const std::string& name) {
  if (name == "water_pressure")
    return "no water presses on a side at the times drawn\n  hint: WATER gives a water "
           "table, JWATER the pressure in joints";
  return "no two blocks have a common face at the times drawn\n  hint: these are faces "
         "that are closed in the first frame of the results";
}

}  // namespace blocks::post
