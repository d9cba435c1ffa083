// INSITU: gives the faces of flush blocks the forces of a stress field, and deformable
// blocks its stress (docs/rest.md#stress-in-the-ground).
#pragma once

#include "dynamics/face_loads.hpp"
#include "geometry/vec2.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// What load_faces has done.
struct InSituReport {
  int faces = 0;     ///< flush faces
  int contacts = 0;  ///< contacts that carry a force
  /// Contacts that the field would pull open: it has tension there, and they are not
  /// bonded, or have a law that carries no tension. They get no force.
  int open = 0;
  /// Contacts that cannot keep the force they got: a step without motion changes their
  /// springs, because the contacts slip or their bonds fail.
  int weak = 0;
  /// Place of the weak contact that loses the largest force in such a step.
  geometry::Vec2 weakest = {0, 0};  ///< [L]
  double normal = 0.0;              ///< [F] its FN
  double shear = 0.0;               ///< [F] its FS
};

/// Loads all faces whose sides are at most `tolerance` [L] apart at both ends. The
/// forces of the field become springs of the contacts at these ends. Offsets keep the
/// springs acting. Contacts there lose the springs that they had; other contacts keep
/// theirs. Also sets the stress of every deformable block to that of the field at its
/// centroid, even if no face of the block is loaded. Sets Settings::in_situ.
InSituReport load_faces(Model& model, const StressField& field, double tolerance);

}  // namespace blocks::dynamics
