// What one contact does with the work of its two blocks in one step: a pure function
// (docs/laws.md#energy).
#pragma once

namespace blocks::dynamics {

/// A contact in one step. Forces are in [F], motions in [L], energies in [F L].
struct ContactStep {
  double closing, sliding;  ///< motions in the step
  double share;             ///< part of the motions that loads the springs
  /// the normal spring before the step, and as it acts in the step
  double normal_before, normal;
  double shear_before, shear;        ///< the shear spring before and after the step
  double normal_force, shear_force;  ///< with dashpots
  double shear_compliance;           ///< [L/F] of the shear spring; 0: it has none
  /// stored by the normal spring before the step, as it acts, and after dilation
  double normal_energy_before, normal_energy_acting, normal_energy;
  double shear_energy_before, shear_energy;  ///< stored by the shear spring
  bool fails;                                ///< it loses its strength in this step
  bool is_hysteretic;                        ///< the normal spring is Walton's

  double stored_before() const { return normal_energy_before + shear_energy_before; }
  double stored() const { return normal_energy + shear_energy; }
};

/// How a contact uses the work that it takes from the blocks, beside the change of the
/// energy that it stores.
struct ContactWork {
  double friction = 0.0, dashpots = 0.0, breaking = 0.0, hysteresis = 0.0;
  double dilation = 0.0;     ///< added to the normal spring; may be negative
  double integration = 0.0;  ///< error of the integration in time
};

/// Divides the work. It is that of the forces after the step of the springs on the
/// motion before it. The work of a spring is that of the mean of its forces before and
/// after; the rest is an error of the integration.
inline ContactWork work_of(const ContactStep& at) {
  ContactWork work;
  const double added = at.normal - at.normal_before;
  const double shear_added = at.shear - at.shear_before;
  const double normal = 0.5 * (at.normal_before + at.normal);
  const double shear = 0.5 * (at.shear_before + at.shear);
  work.dashpots = (at.normal_force - at.normal) * at.closing +
                  (at.shear_force - at.shear) * at.sliding;
  work.dilation = at.normal_energy - at.normal_energy_acting;
  work.integration = 0.5 * added * at.closing + 0.5 * shear_added * at.sliding;
  // In its first step a contact moves farther than its springs.
  const double idle = 1.0 - at.share;
  work.integration += idle * (normal * at.closing + shear * at.sliding);

  const double slip = at.share * at.sliding - shear_added * at.shear_compliance;
  (at.fails ? work.breaking : work.friction) += shear * slip;
  const double lost = at.share * (normal * at.closing) -
                      (at.normal_energy_acting - at.normal_energy_before);
  (at.fails           ? work.breaking
   : at.is_hysteretic ? work.hysteresis
                      : work.integration) += lost;
  return work;
}

}  // namespace blocks::dynamics
