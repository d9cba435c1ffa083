#include "post/figure/crack_faces.hpp"

#include <algorithm>

#include "post/figure/half.hpp"

namespace blocks::post {

using namespace draw;

double crack_width(const Axes& axes, const FigureScales& scales) {
  constexpr double share_of_block = 0.05, thinnest = 1.0, widest = 2.6;
  return std::clamp(share_of_block * scales.block_size * axes.scale(), thinnest,
                    widest);
}

void draw_crack_faces(Pen& pen, const Axes& axes, const Frame& now,
                      const CrackedBlocks& cracked, const FigureScales& scales,
                      const std::optional<double>& mirror_x) {
  constexpr int most = 64;  // a path of many lines is slow
  cairo_t* cairo = pen.cairo();
  const double width = crack_width(axes, scales);
  const Half half{axes, mirror_x};
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  for (const bool rim : {true, false}) {
    const auto stroke = [&] {
      if (rim)
        pen.stroke(width + 1.4, white, 0.8);
      else
        pen.stroke(width, crack_colour);
    };
    int count = 0;
    for (std::size_t b = 0; b < cracked.faces.size(); ++b)
      for (std::size_t k = 0; k < cracked.faces[b].size(); ++k) {
        const auto& outline = now.outlines[b];
        if (cracked.faces[b][k] == 0 || k >= outline.size())
          continue;
        if (half.trace(cairo, outline[k], outline[(k + 1) % outline.size()]) &&
            ++count % most == 0)
          stroke();
      }
    stroke();
  }
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
}

}  // namespace blocks::post
