// SERVO: chooses the velocities of driven blocks so that their sides hold a normal
// stress (docs/rest.md#servos). A step does this after add_loads and before move_blocks
// (docs/architecture.md#one-step).
#pragma once

#include "dynamics/contacts/contact_arrays.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// The part of the missing force that a servo adds per step, in (0, 2). A servo that
/// acts on a fixed block through linear springs reduces its error by the factor
/// 1 - servo_gain per step. A smaller gain is slower. Above 1 the error alternates in
/// sign, and dashpots may make it grow (docs/rest.md#servos).
inline constexpr double servo_gain = 0.5;

/// Stress and stiffness of the contacts of a servo's block, from their springs.
struct ServoContacts {
  double stress = 0.0;  ///< [F/L^2] normal stress on the side, tension positive
  /// [F/L] of all contacts against a motion of the block along the outward normal of
  /// the side. It may be larger than the change of the force per distance, never
  /// smaller; otherwise the servo would go too far. It is 0 without contacts.
  double stiffness = 0.0;
};

/// Reads the springs at the end of the step. Dashpots and loads on the block do not
/// count. Call it when the springs have advanced. along: unit vector along the side;
/// length: that of the side, [L] > 0.
ServoContacts read_servo_contacts(const Model& model, const ContactArrays& contacts,
                                  const Servo& servo, const Vec2& along, double length);

/// Sets the velocities of all servos' blocks and drives for this step. Every servo must
/// have a drive.
void control_servos(Model& model, const ContactArrays& contacts);

}  // namespace blocks::dynamics
