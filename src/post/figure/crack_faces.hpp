// Draws the faces of cracks where they are now, on both pieces.
#pragma once

#include <optional>

#include "draw/axes.hpp"
#include "draw/pen.hpp"
#include "post/figure/figure_scales.hpp"
#include "post/read/crack_tracker.hpp"

namespace blocks::post {

/// The colour of the faces of cracks: a signal red, brighter than any colour of a map
/// or a material. A white rim separates it from every ground.
constexpr draw::Colour crack_colour{0.9, 0.05, 0.0};

/// Returns the width of the line of a face on the page.
double crack_width(const draw::Axes& axes, const FigureScales& scales);

/// Draws the faces of all cracks up to a frame. With a symmetry plane x = mirror_x [L],
/// draws the mirrored half instead.
void draw_crack_faces(draw::Pen& pen, const draw::Axes& axes, const Frame& now,
                      const CrackedBlocks& cracked, const FigureScales& scales,
                      const std::optional<double>& mirror_x);

}  // namespace blocks::post
