// Hatching, symmetry planes and the sign of a water table, in pictures and legends.
#pragma once

#include <Eigen/Core>

#include "draw/pen.hpp"

namespace blocks::post {

/// Hatches the current path, and keeps it, to show a fixed block. The lines are light
/// on a dark background.
void hatch(draw::Pen& pen, const draw::Colour& ground);

/// Draws a symmetry plane from one point of the page to another, with short strokes on
/// the right: the blocks are on the left.
void draw_plane(draw::Pen& pen, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// The colour of the water table.
constexpr draw::Colour water_colour{0.07, 0.42, 0.71};

/// Draws the sign of a water table, a triangle whose tip is at a point of the page.
void draw_water_sign(draw::Pen& pen, double x, double y);

}  // namespace blocks::post
