// Draws the faces between blocks in the colours of their opening or shear displacement,
// and the sides in those of the pressure of water.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "draw/axes.hpp"
#include "draw/pen.hpp"
#include "post/figure/figure_scales.hpp"
#include "post/read/face_motion.hpp"
#include "post/read/quantity.hpp"

namespace blocks::post {

/// Returns label, dimension and colours of "opening", "shear_displacement" or
/// "water_pressure", without values.
Quantity face_quantity(const std::string& name);

/// Returns the opening or the shear displacement at both ends of a face [L]. In the
/// mirror image shear has the other sign.
Eigen::Vector2d face_values(const std::string& name, const FaceMotion& motion,
                            bool mirrored);

/// A side with the values of that quantity at its ends.
struct ValuedSide {
  std::array<Eigen::Vector2d, 2> ends;  ///< [L]
  Eigen::Vector2d values;
};
/// Returns both sides of all faces, or the sides with pressure.
std::vector<ValuedSide> valued_sides(const std::string& name, const Picture& picture,
                                     bool mirrored);

/// Draws these sides of a picture, the largest values on top, and then the outlines of
/// all blocks. With a symmetry plane x = mirror_x [L], draws the mirrored half instead.
void draw_face_sides(draw::Pen& pen, const draw::Axes& axes, const Picture& picture,
                     const FigureScales& scales, const FigureOptions& options,
                     const std::optional<double>& mirror_x);

/// Returns "no two blocks have a common face ..." with a hint, or that there is no
/// water.
std::string no_faces_text(const std::string& name);

}  // namespace blocks::post
