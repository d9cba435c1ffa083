// The model inside the axes of a figure: blocks, forces, arrows, marks.
#pragma once

#include "post/axes.hpp"
#include "post/figure_scales.hpp"
#include "post/pen.hpp"

namespace blocks::post {

void draw_scene(Pen& pen, const Axes& axes, const Picture& picture,
                const FigureScales& scales, const FigureOptions& options);

/// Slanting lines over the present path, which stays: a fixed block. Light ones on a
/// dark ground.
void hatch(Pen& pen, const Colour& ground);

/// An arrow from (x, y) on the page.
void draw_arrow(Pen& pen, double x, double y, double dx, double dy);

/// Its length on the page for the largest vector [page units].
double arrow_length(const Axes& axes, const FigureScales& scales);

/// Colour of a block's value by its place s in the range, 0 to 1.
Colour shade(bool is_signed, double s);

Colour colour_of_material(int material, const FigureOptions& options);

}  // namespace blocks::post
