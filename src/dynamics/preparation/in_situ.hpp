// INSITU: gives the faces of flush blocks the forces of a stress field, and deformable
// blocks its stress (docs/rest.md#stress-in-the-ground).
#pragma once

#include <vector>

#include "geometry/vec2.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// What load_faces has done.
struct InSituReport {
  int faces = 0;     ///< flush faces of two blocks, and sides on symmetry planes
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
  double lost = 0.0;                ///< [F] that it loses

  /// Corners on symmetry planes where the field has shear, which planes do not carry.
  int sheared = 0;

  /// Counts a weak contact that loses `loses`, [F], of its force.
  void add_weak(const geometry::Vec2& at, double its_normal, double its_shear,
                double loses);
};

/// Returns the gap or overlap up to which two sides are flush, [L]: a hundredth of
/// CTOL.
double flush_tolerance(const Settings& settings);

/// Loads all flush faces, also those on symmetry planes. The forces of the field become
/// springs of the contacts at their ends. Offsets keep the springs acting. Contacts
/// there lose the springs that they had; other contacts keep theirs. Also sets the
/// stress of every deformable block to that of the field at its centroid, even if no
/// face of the block is loaded. Sets Settings::in_situ and Settings::ground.
InSituReport load_faces(Model& model, const StressField& field);

/// Frees fixed blocks. Two blocks that were both fixed when INSITU acted, and have been
/// until now, had no contacts with each other: their faces are loaded by its field.
void free_in_ground(Model& model, const std::vector<int>& chosen);

}  // namespace blocks::dynamics
