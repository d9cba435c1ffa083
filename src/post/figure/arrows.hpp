// Draws the arrows of velocities, displacements and forces.
#pragma once

#include "draw/axes.hpp"
#include "draw/pen.hpp"
#include "post/figure/figure_scales.hpp"
#include "post/figure/half.hpp"

namespace blocks::post {

/// Draws an arrow from (x, y) on the page.
void draw_arrow(draw::Pen& pen, double x, double y, double dx, double dy);

/// Draws the arrows of the blocks that the picture shows, the shortest on top. An arrow
/// that leaves the picture ends at its frame, with an open head.
void draw_arrows(draw::Pen& pen, const Half& half, const Picture& picture,
                 const FigureScales& scales, const FigureOptions& options);

/// Returns the length of the arrow for the reference vector [page units].
double arrow_length(const draw::Axes& axes, const FigureScales& scales);

}  // namespace blocks::post
