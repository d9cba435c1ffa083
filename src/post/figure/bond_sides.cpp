#include "post/figure/bond_sides.hpp"

#include <algorithm>

#include "draw/joint_colours.hpp"
#include "post/figure/half.hpp"
#include "post/read/joint_faces.hpp"

namespace blocks::post {

using namespace draw;

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

void draw_bond_sides(Pen& pen, const Axes& axes, const Picture& picture,
                     const FigureScales& scales,
                     const std::optional<double>& mirror_x) {
  constexpr double share_of_block = 0.06, thinnest = 0.9, widest = 3.4;
  const double width =
      std::clamp(share_of_block * scales.block_size * axes.scale(), thinnest, widest);
  cairo_t* cairo = pen.cairo();
  const Half half{axes, mirror_x};
  pen.dashes({});
  for (const auto& outline : picture.now.outlines) {
    for (std::size_t k = 0; k < outline.size(); ++k)
      half.trace(cairo, outline[k], outline[(k + 1) % outline.size()]);
    pen.stroke(std::min(0.4 * width, 0.8), no_joint_colour);
  }
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  for (const FacePart& part : face_parts(picture.now, picture.contacts)) {
    const bool failed = part.bond == Bond::failed || part.bond == Bond::weakened;
    const double share = scales.slip > 0.0 ? part.slip / scales.slip : 0.0;
    set_bond_dashes(pen, part.bond);
    half.trace(cairo, part.from, part.to);
    pen.stroke(width, failed ? slip_colour(share) : bonded_colour);
  }
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
  pen.dashes({});
}

const char* no_laws_text() {
  return "no contact has the law of a joint at the times drawn\n  hint: the cards "
         "JOINT "
         "and JPAIR give joints a law; results of older versions have none";
}

}  // namespace blocks::post
