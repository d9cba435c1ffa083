// The critical time step (4) and the additional limits of docs/theory.md#time-step.
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Chooses the largest step that (4), FRACTION and deformability allow, and records the
/// block that limits it. The stiffness in (4) is the largest that STIFF and the laws of
/// joints give a contact of the block (docs/laws.md#length). Without FRACTION, the safe
/// fraction for the damping in force is taken, and contact_shares(). In deformable runs
/// the step is at most half the smallest l sqrt(rho / C11) over the free blocks, with
/// l = thickness(). MDAMP multiplies that by sqrt(1 + z^2) - z. If the blocks of a
/// material may split, their pieces count: masses of the least area, and
/// min_thickness_of_pieces(). So no crack changes the time step.
TimeStep choose_time_step(const Model& model);

/// Returns the step that each free block would allow by itself, [T] (n); 0 for other
/// blocks. The stiffness of STIFF is multiplied by the block's entry of
/// `contact_share`, (n), which is 1 for a block with as many contacts as
/// safe_fraction() assumes. A law of joints needs no factor: its stiffness belongs to
/// whole faces.
Eigen::VectorXd steps_of_blocks(const Model& model,
                                const Eigen::VectorXd& contact_share);

/// Returns the shorter side of the rectangle with the second moments (xx, xy, yy) and
/// the mass, or the area, of a block, [L]. It is the thickness of the block in (11).
double thickness(const Eigen::Vector3d& second_moment, double mass);

/// Returns the least thickness of the pieces of a deformable block, half the square
/// root of the least area, [L]. Thinner pieces are refused
/// (docs/cracks.md#the-time-step).
double min_thickness_of_pieces(double min_area);

/// Returns the extents of the current corners of block b along x and y, [L].
Vec2 extent(const Blocks& blocks, int b);

/// Returns the least distance of two parallel lines that have all current corners of
/// block b between them, [L].
double min_width(const Blocks& blocks, int b);

}  // namespace blocks::dynamics
