// Draws the sides of blocks in the colours of their joints.
#pragma once

#include "draw/axes.hpp"
#include "draw/pen.hpp"
#include "post/figure/figure_scales.hpp"

namespace blocks::post {

/// Draws the sides of all blocks of a frame, those without a joint first. With a
/// symmetry plane x = mirror_x [L], draws the mirrored half instead.
void draw_joint_sides(draw::Pen& pen, const draw::Axes& axes, const Frame& frame,
                      const FigureScales& scales,
                      const std::optional<double>& mirror_x);

}  // namespace blocks::post
