// Draws the sides of blocks in colours: of their joints, of the states of their bonds,
// of their opening, shear displacement or pressure of water, and those of cracks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "draw/pen.hpp"
#include "post/figure/figure_scales.hpp"
#include "post/figure/half.hpp"
#include "post/read/face_motion.hpp"
#include "post/read/frame_quantity.hpp"

namespace blocks::post {

/// The colour of a face that has not failed.
constexpr draw::Colour bonded_colour{0.05, 0.28, 0.47};

/// The colour of the faces of cracks: a signal red, brighter than any colour of a map
/// or a material. A white rim separates it from every ground.
constexpr draw::Colour crack_colour{0.9, 0.05, 0.0};

/// Returns the colour of a failed face, which has slipped by a part of the largest
/// slip, 0 to 1 (clamped): orange, red, dark red.
draw::Colour slip_colour(double part);

/// Sets the dashes of the line of a face: none unless it is weakened.
void set_bond_dashes(draw::Pen& pen, quantities::Bond bond);

/// Draws the sides of all blocks in the colours of their joints, those without a joint
/// first.
void draw_joint_sides(draw::Pen& pen, const Half& half, const Picture& picture,
                      const FigureScales& scales);

/// Draws the outlines of all blocks, then the faces with a law by the state of their
/// bond: intact, failed, and how far they have slipped.
void draw_bond_sides(draw::Pen& pen, const Half& half, const Picture& picture,
                     const FigureScales& scales);

/// Draws the faces of all cracks up to the time of the picture, on both pieces. Its
/// cracks are known.
void draw_crack_faces(draw::Pen& pen, const Half& half, const Picture& picture,
                      const FigureScales& scales);

/// Draws the faces between blocks, or the sides, in the colours of their values, the
/// largest on top, and then the outlines of all blocks.
void draw_face_sides(draw::Pen& pen, const Half& half, const Picture& picture,
                     const FigureScales& scales, const FigureOptions& options);

/// Returns label, dimension and colours of "opening", "shear_displacement" or
/// "water_pressure", without values.
Quantity face_quantity(const std::string& name);

/// A side with the values of that quantity at its ends.
struct ValuedSide {
  std::array<Eigen::Vector2d, 2> ends;  ///< [L]
  Eigen::Vector2d values;
};
/// Returns both sides of all faces, or the sides with pressure. In the mirror image
/// shear has the other sign.
std::vector<ValuedSide> valued_sides(const std::string& name, const Picture& picture,
                                     bool mirrored);

/// Returns "no contact has the law of a joint ..." with a hint.
const char* no_laws_text();

/// Returns "no two blocks have a common face ..." with a hint, or that there is no
/// water.
std::string no_faces_text(const std::string& name);

}  // namespace blocks::post
