// SERVO: chooses the velocities of driven blocks so that their sides hold a normal
// stress (docs/rest.md#servos). This happens between the third and the fifth call of a
// step.
#pragma once

#include "dynamics/contacts/contact_arrays.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// The part of the missing force that a servo adds per step, in (0, 2). A servo that
/// acts on a fixed block through linear springs reduces its error by the factor
/// 1 - servo_gain per step. A smaller gain is slower. Above 1 the error alternates in
/// sign, and dashpots may make it grow (docs/rest.md#servos).
inline constexpr double servo_gain = 0.5;

/// What the springs of the contacts of a servo's block show in a step.
struct ServoContacts {
  double stress = 0.0;  ///< [F/L^2] normal stress on the side, tension positive
  /// [F/L] by how much the force on the block decreases if it moves along the outward
  /// normal of the side, per distance, or more; 0: no contact resists
  double stiffness = 0.0;
};

/// Reads the springs at the end of the step. Dashpots and loads on the block do not
/// count. Call it after find_contact_forces and before the springs advance. along: unit
/// vector along the side; length: that of the side, [L] > 0.
ServoContacts read_servo_contacts(const Model& model, const ContactArrays& contacts,
                                  const Servo& servo, const Vec2& along, double length);

/// Sets the velocities of all servos' blocks and drives for this step. Every servo must
/// have a drive.
void control_servos(Model& model, const ContactArrays& contacts);

}  // namespace blocks::dynamics
