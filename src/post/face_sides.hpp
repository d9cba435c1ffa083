// Draws the faces between blocks in the colours of their opening or shear displacement.
#pragma once

#include <optional>
#include <string>

#include "post/axes.hpp"
#include "post/face_motion.hpp"
#include "post/figure_scales.hpp"
#include "post/pen.hpp"
#include "post/quantity.hpp"

namespace blocks::post {

/// Returns label, dimension and colours of "opening" or "shear_displacement", without
/// values.
Quantity face_quantity(const std::string& name);

/// Returns that quantity at both ends of a face [L]. In the mirror image shear has the
/// other sign.
Eigen::Vector2d face_values(const std::string& name, const FaceMotion& motion,
                            bool mirrored);

/// Draws both sides of all faces of a picture, the largest values on top, and then the
/// outlines of all blocks. With a symmetry plane x = mirror_x [L], draws the mirrored
/// half instead.
void draw_face_sides(Pen& pen, const Axes& axes, const Picture& picture,
                     const FigureScales& scales, const FigureOptions& options,
                     const std::optional<double>& mirror_x);

/// Returns "no two blocks have a common face ..." with a hint.
std::string no_faces_text();

}  // namespace blocks::post
