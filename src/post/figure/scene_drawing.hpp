// Draws the model inside the axes of a figure: blocks and all that lies on them.
#pragma once

#include "draw/axes.hpp"
#include "draw/pen.hpp"
#include "post/figure/figure_scales.hpp"

namespace blocks::post {

void draw_scene(draw::Pen& pen, const draw::Axes& axes, const Picture& picture,
                const FigureScales& scales, const FigureOptions& options);

/// Returns the colour of a material; it is pale below lines.
draw::Colour colour_of_material(int material, const FigureOptions& options);

}  // namespace blocks::post
