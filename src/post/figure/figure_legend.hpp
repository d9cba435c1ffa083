// The legend, a strip beside or below the pictures that explains colours, lines and
// arrows.
#pragma once

#include "draw/pen.hpp"
#include "post/figure/figure_scales.hpp"

namespace blocks::post {

/// The position, width and height of the strip, and the length on the page of the arrow
/// for the reference vector.
struct LegendPlace {
  double x, top, width, height, arrow;
  bool below = false;  ///< the strip is below the pictures
};

/// Returns the smallest height that the legend needs beside the pictures.
double legend_height(const FigureScales& scales, const FigureOptions& options);

/// Returns the height of the legend below the pictures, in a strip of this width.
double legend_height_below(const FigureScales& scales, const FigureOptions& options,
                           double width);

void draw_legend(draw::Pen& pen, const LegendPlace& place, const Picture& picture,
                 const FigureScales& scales, const FigureOptions& options);

}  // namespace blocks::post
