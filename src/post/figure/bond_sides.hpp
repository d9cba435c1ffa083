// Draws the faces of blocks by the state of their bond: intact, failed, and how far
// they have slipped.
#pragma once

#include <optional>

#include "draw/axes.hpp"
#include "draw/pen.hpp"
#include "post/figure/figure_scales.hpp"

namespace blocks::post {

/// The colour of a face that has not failed.
constexpr draw::Colour bonded_colour{0.05, 0.28, 0.47};

/// Returns the colour of a failed face, which has slipped by a part of the largest
/// slip, 0 to 1 (clamped): orange, red, dark red.
draw::Colour slip_colour(double part);

/// Sets the dashes of the line of a face: none unless it is weakened.
void set_bond_dashes(draw::Pen& pen, quantities::Bond bond);

/// Draws the outlines of all blocks of a picture, then the faces with a law. With a
/// symmetry plane x = mirror_x [L], draws the mirrored half instead.
void draw_bond_sides(draw::Pen& pen, const draw::Axes& axes, const Picture& picture,
                     const FigureScales& scales, const std::optional<double>& mirror_x);

/// Returns "no contact has the law of a joint ..." with a hint.
const char* no_laws_text();

}  // namespace blocks::post
