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
  int open = 0;      ///< contacts without tensile strength where the field has tension
  int weak = 0;      ///< loaded contacts that fail or slip in the first step
  /// The weak contact whose shear exceeds its strength most.
  geometry::Vec2 weakest = {0, 0};  ///< [L]
  double normal = 0.0;              ///< [F] its FN
  double shear = 0.0;               ///< [F] its FS
};

/// Puts the forces of the field on both ends of all faces whose sides are at most
/// `tolerance` [L] apart there, as springs whose offsets keep them acting. Springs that
/// contacts there have already are replaced; other contacts keep theirs. Sets the
/// stress of all blocks if they are deformable, and Settings::in_situ.
InSituReport load_faces(Model& model, const StressField& field, double tolerance);

}  // namespace blocks::dynamics
