// Draws the model inside the axes of a figure: blocks, forces, arrows and marks.
#pragma once

#include "post/axes.hpp"
#include "post/figure_scales.hpp"
#include "post/pen.hpp"

namespace blocks::post {

void draw_scene(Pen& pen, const Axes& axes, const Picture& picture,
                const FigureScales& scales, const FigureOptions& options);

/// Hatches the current path, and keeps it, to show a fixed block. The lines are light
/// on a dark background.
void hatch(Pen& pen, const Colour& ground);

/// Draws an arrow from (x, y) on the page.
void draw_arrow(Pen& pen, double x, double y, double dx, double dy);

/// Returns the length of the arrow for the reference vector [page units].
double arrow_length(const Axes& axes, const FigureScales& scales);

Colour colour_of_material(int material, const FigureOptions& options);

}  // namespace blocks::post
