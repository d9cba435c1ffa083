// Settings from the preliminary cards and the global problem cards (report A.1, A.2).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/decimal.hpp"
#include "geometry/vec2.hpp"
#include "model/joint_law.hpp"
#include "model/stress_field.hpp"

namespace blocks {

/// MATERIAL card. Only deformable blocks need the elastic constants.
struct Material {
  double youngs_modulus = 0.0;  ///< [F/L^2] E
  double shear_modulus = 0.0;   ///< [F/L^2] G; G > E/3 for nu < 0.5
  double density = 0.0;         ///< [M/L^3] > 0
  std::string name = {};        ///< shown instead of the number; may be empty
  double damping = 0.0;         ///< MDAMP: z, fraction of critical damping, 0 to 1

  double c11() const;  ///< [F/L^2] plane strain stiffness (12)
  double c12() const;  ///< [F/L^2] plane strain coupling (12)
};

/// CRACK card: when the blocks of a material split (docs/cracks.md#when-blocks-split).
struct CrackRule {
  double strength = 0.0;        ///< [F/L^2] ten > 0, of the largest principal stress
  double min_area = 0.0;        ///< [L^2] amin > 0, of a piece
  double point_strength = 0.0;  ///< [F/L^2] tenp under point loads; 0: no such cracks
  int joint = 0;                ///< joint id of the new faces
};

/// UNITS card: the names of the units in which all values are given. All are empty if
/// the deck does not tell.
struct Units {
  std::string length, mass, time;

  bool known() const { return !length.empty(); }
  bool operator==(const Units&) const = default;
};

/// GRAVITY with a ramp: the acceleration changes linearly in time from `from` to
/// Settings::gravity.
struct GravityRamp {
  geometry::Vec2 from = {0, 0};  ///< [L/T^2] acceleration at `begin`
  double begin = 0.0;            ///< [T]
  double duration = 0.0;         ///< [T] 0: no ramp
};

/// A symmetry plane through a and b; the blocks are on its left
/// (docs/theory.md#symmetry-planes).
struct Plane {
  geometry::Vec2 a, b;  ///< [L]
};

/// The settings in force.
struct Settings {
  std::string title;
  Units units;
  int max_blocks = 0;   ///< NBLOKM: more blocks are refused
  int max_corners = 0;  ///< NCMAX: a block with more corners is refused
  geometry::Vec2 lower = {0, 0}, upper = {0, 0};  ///< [L] domain: XL, YL, XU, YU
  int boxes_x = 1, boxes_y = 1;                   ///< IBOXES, JBOXES: without effect
  double contact_tolerance = 0.1;                 ///< [L] CTOL
  double normal_stiffness = 1e6;                  ///< [F/L] STIFN per unit thickness
  double shear_stiffness = 1e6;                   ///< [F/L] STIFS
  double fraction = 0.0;            ///< TFRAC of (4); 0: safe_fraction.hpp
  double damping = 0.0;             ///< BETA, fraction of critical damping (18)
  double friction = 0.0;            ///< FRIC
  geometry::Vec2 gravity = {0, 0};  ///< [L/T^2] at the end of the ramp
  GravityRamp gravity_ramp;
  double local_damping = 0.0;    ///< LOCDAMP: alpha, 0 <= alpha < 1
  bool kinetic_damping = false;  ///< KINDAMP
  bool mass_scaling = false;     ///< MSCALE
  /// INSITU has acted: contacts without the law of a joint keep a LawState too.
  bool in_situ = false;
  StressField ground;  ///< of the last INSITU
  bool rigid = false;  ///< IRIGID
  std::map<int, Material> materials;
  std::map<int, JointLaw> joint_laws;  ///< JOINT, WALTON, BARTON by joint id
  /// JPAIR: joint id of two materials, the lower number first
  std::map<std::pair<int, int>, int> joint_of_materials;
  std::map<int, CrackRule> crack_rules;  ///< CRACK by material number
  std::vector<Plane> planes;
  std::uint64_t seed = 1982;  ///< ISEED
  // values of the last ORIENT and MERGE cards
  geometry::Decimal angle_min, angle_max;        ///< degrees (ORIENT)
  std::optional<geometry::Decimal> merge_ratio;  ///< MERGE
  int layers_made = 0;

  /// Returns the acceleration due to gravity at a time, [L/T^2].
  geometry::Vec2 gravity_at(double time) const;
};

/// HISTORY card: the quantities recorded at multiples of an interval.
struct HistoryRequest {
  double interval = 0.0;  ///< [T]; 0: no histories
  std::vector<std::string> quantities = {};
};

/// OUTPUT and PLOTS: output interval and next due time. Interval 0: no output.
struct OutputClock {
  double interval = 0.0;  ///< [T]
  double due = 0.0;       ///< [T] TOUT, TPLOT
};

/// PLOTS, , n: a frame every `interval` steps after step `origin`. Interval 0: none.
struct StepClock {
  long interval = 0, origin = 0;

  bool is_due(long step) const {
    return interval > 0 && step > origin && (step - origin) % interval == 0;
  }
};

}  // namespace blocks
