// Draws the sides of blocks in the colours of their joints.
#pragma once

#include "post/axes.hpp"
#include "post/figure_scales.hpp"
#include "post/pen.hpp"

namespace blocks::post {

/// Draws the sides of all blocks of a frame, those without a joint first. With a
/// symmetry plane x = mirror_x [L], draws the mirrored half instead.
void draw_joint_sides(Pen& pen, const Axes& axes, const Frame& frame,
                      const FigureScales& scales,
                      const std::optional<double>& mirror_x);

}  // namespace blocks::post
