// The laws of joints with strength (docs/laws.md): what the cards JOINT, WALTON and
// BARTON of one joint id define. Stresses and strengths are per area of the joint.
#pragma once

#include <limits>

namespace blocks {

/// Which function gives the force of a contact.
enum class LawKind : int {
  coulomb = 0,  ///< linear normal spring; Mohr-Coulomb strength (JOINT)
  walton = 1,   ///< Walton's normal spring with hysteresis; Mohr-Coulomb (WALTON)
  barton = 2,   ///< Bandis' normal closure; Barton's shear strength (BARTON)
};

/// The law of one joint id.
struct JointLaw {
  LawKind kind = LawKind::coulomb;
  // JOINT. The residual values replace the peak values once a contact has failed.
  double friction = 0.0;                                   ///< coefficient
  double cohesion = 0.0, tension = 0.0;                    ///< [F/L^2] strengths >= 0
  double residual_friction = 0.0;                          ///< coefficient
  double residual_cohesion = 0.0, residual_tension = 0.0;  ///< [F/L^2] >= 0
  double dilation = 0.0;  ///< tangent of the dilation angle
  /// [L] slip beyond which the joint opens no further
  double dilation_limit = std::numeric_limits<double>::infinity();
  /// [F/L^3] stiffnesses per area; 0: STIFF of each contact, whatever its length
  double normal_stiffness = 0.0, shear_stiffness = 0.0;
  // WALTON
  double restitution = 1.0;  ///< e in (0, 1]
  // BARTON
  double roughness = 0.0;          ///< JRC
  double wall_strength = 0.0;      ///< [F/L^2] JCS > 0
  double residual_angle = 0.0;     ///< degrees, phi_r
  double peak_slip = 0.0;          ///< [L] slip at peak strength
  double initial_stiffness = 0.0;  ///< [F/L^3] kni, normal stiffness without load
  double largest_closure = 0.0;    ///< [L] vm
  double largest_stiffness = 0.0;  ///< [F/L^3] knmax
  /// part of its shear strength that acts; less than 1 in trials of FOS
  double strength_share = 1.0;

  bool operator==(const JointLaw&) const = default;
};

}  // namespace blocks
