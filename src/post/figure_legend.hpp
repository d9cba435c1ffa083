// The legend, a strip beside the figure that explains its colours, lines and arrows.
#pragma once

#include "post/figure_scales.hpp"
#include "post/pen.hpp"

namespace blocks::post {

/// The position and height of the strip, and the length on the page of the arrow for
/// the reference vector.
struct LegendPlace {
  double x, top, height, arrow;
};

/// Returns the smallest height that the legend needs.
double legend_height(const FigureScales& scales, const FigureOptions& options);

void draw_legend(Pen& pen, const LegendPlace& place, const Picture& picture,
                 const FigureScales& scales, const FigureOptions& options);

/// Returns a label with its unit: "speed [m/s]", "speed [L T⁻¹]".
std::string with_unit(const std::string& label, const Dimension& dimension,
                      const FigureOptions& options);

}  // namespace blocks::post
