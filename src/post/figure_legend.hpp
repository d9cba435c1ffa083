// The strip beside a figure that says what its colours, lines and arrows mean.
#pragma once

#include "post/figure_scales.hpp"
#include "post/pen.hpp"

namespace blocks::post {

/// arrow: length on the page of the usual largest vector. height: of the strip.
struct LegendPlace {
  double x, top, height, arrow;
};

/// The least height it needs.
double legend_height(const FigureScales& scales, const FigureOptions& options);

void draw_legend(Pen& pen, const LegendPlace& place, const Picture& picture,
                 const FigureScales& scales, const FigureOptions& options);

/// "speed [m/s]", "speed [L T⁻¹]".
std::string with_unit(const std::string& label, const Dimension& dimension,
                      const FigureOptions& options);

}  // namespace blocks::post
