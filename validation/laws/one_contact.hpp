// One contact with the law of a joint, driven along a path, for tests and figures.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "dynamics/kernels/barton_law.hpp"
#include "dynamics/kernels/coulomb_law.hpp"
#include "dynamics/kernels/walton_law.hpp"

namespace blocks::validation {

using dynamics::BandisClosure, dynamics::ContactForce, dynamics::ContactMotion;
using dynamics::ContactState, dynamics::LawValues;

inline constexpr double degree = std::numbers::pi / 180.0;
inline constexpr double MN = 1e6, MPa = 1e6, GPa = 1e9, mm = 1e-3;

enum class Kind { coulomb, walton, barton };

/// A contact without dashpot. Its steps last 1 s, so that velocities are displacements.
struct OneContact {
  Kind kind = Kind::coulomb;
  LawValues<double> law = {};
  ContactState<double> state = {};
  ContactForce<double> force = {};
  double overlap = 1.0;  ///< [L] limits the first step only
  bool starts = false;   ///< the next step is the first

  OneContact(Kind of, double kn, double ks) : kind(of) {
    state.stiffness = kn, state.shear_stiffness = ks;
    law.dilation_limit = std::numeric_limits<double>::infinity();
    law.strength_share = 1.0;
    state.failed = 1.0, state.length = 1.0;
  }
  /// Moves the two sides towards each other by `closing` and along each other by
  /// `sliding` [L] in one step.
  void move(double closing, double sliding) {
    const ContactMotion<double> motion = {closing, sliding, overlap, 0.0,
                                          starts ? 1.0 : 0.0};
    starts = false;
    if (kind == Kind::coulomb)
      apply_coulomb(law, 1.0, motion, state, force);
    else if (kind == Kind::walton)
      apply_walton(law, 1.0, motion, state, force);
    else
      apply_barton(law, 1.0, motion, state, force);
  }
  double energy() const {
    const double normal = kind == Kind::coulomb  ? coulomb_energy(state)
                          : kind == Kind::walton ? walton_energy(law, state)
                                                 : barton_energy(law, state);
    return normal + shear_energy(state);
  }
};

/// A joint of 1 m with 0.5 MPa of cohesion, 35 degrees, residual 0 and 30 degrees.
inline OneContact bonded_joint(double normal_force) {
  OneContact contact(Kind::coulomb, 10 * GPa, 10 * GPa);
  contact.law.friction = std::tan(35 * degree);
  contact.law.residual_friction = std::tan(30 * degree);
  contact.law.cohesion = 0.5 * MPa;
  contact.state.normal = normal_force;
  contact.state.bonded = 1.0, contact.state.failed = 0.0;
  return contact;
}

/// A rough joint of 1 m: JRC 10, JCS 100 MPa, 30 degrees, kni 10 GPa/m, vm 0.2 mm.
inline OneContact rough_joint(double shear_stiffness) {
  OneContact contact(Kind::barton, 10 * GPa, shear_stiffness);
  contact.law.roughness = 10.0, contact.law.wall_strength = 100 * MPa;
  contact.law.residual_angle = 30 * degree;
  contact.law.peak_slip = std::pow(10.0, 0.33) / 500.0;  // L/500 (JRC/L)^0.33
  contact.law.largest_closure = 0.2 * mm;
  contact.law.linear_from = 0.2 * mm * (1.0 - std::sqrt(10.0 / 1000.0));
  return contact;
}
/// Loads a rough joint to a normal force.
inline void load(OneContact& contact, double normal_force) {
  const BandisClosure<double> bandis(contact.law, contact.state.length,
                                     contact.state.stiffness);
  contact.move(bandis.closure(normal_force) - bandis.closure(contact.state.normal),
               0.0);
}
/// Slides by `sliding` in `steps` steps while the normal force is kept.
inline void slide(OneContact& contact, double normal_force, double sliding, int steps) {
  const BandisClosure<double> bandis(contact.law, contact.state.length,
                                     contact.state.stiffness);
  for (int i = 0; i < steps; ++i) {
    const double closing =
        contact.kind == Kind::barton
            ? bandis.closure(normal_force) - bandis.closure(contact.state.normal)
            : (normal_force - contact.state.normal) / contact.state.stiffness;
    contact.move(closing, sliding / steps);
  }
}

}  // namespace blocks::validation
