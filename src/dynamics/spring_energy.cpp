#include "dynamics/spring_energy.hpp"

#include <cstddef>

#include "dynamics/kernels/barton_law.hpp"
#include "dynamics/kernels/coulomb_law.hpp"
#include "dynamics/kernels/walton_law.hpp"

namespace blocks::dynamics {

ContactState<double> state_of(const Contact& contact, const JointState& state) {
  ContactState<double> now;
  now.normal = contact.normal_elastic, now.shear = contact.shear_elastic;
  each_state([](double& to, auto from) { to = static_cast<double>(from); }, now, state);
  return now;
}

SpringEnergies::SpringEnergies(const Settings& settings, const LawTable& laws)
    : settings_(settings), laws_(laws) {}

LawValues<double> SpringEnergies::values_of(int law) const {
  const LawValues<const double*>& all = laws_.columns().values;
  const auto i = static_cast<std::size_t>(law);
  return {all.friction[i],          all.cohesion[i],          all.tension[i],
          all.residual_friction[i], all.residual_cohesion[i], all.residual_tension[i],
          all.dilation[i],          all.dilation_limit[i],    all.unloading_ratio[i],
          all.roughness[i],         all.wall_strength[i],     all.residual_angle[i],
          all.peak_slip[i],         all.largest_closure[i],   all.linear_from[i],
          all.strength_share[i]};
}

SpringEnergy SpringEnergies::of(int law, ContactState<double> state) const {
  if (!(state.stiffness > 0.0)) {
    state.stiffness = settings_.normal_stiffness;
    state.shear_stiffness = settings_.shear_stiffness;
  }
  const double shear = shear_energy(state);
  switch (bit_of(law)) {
  case walton_bit:
    return {walton_energy(values_of(law), state), shear};
  case barton_bit:
    return {barton_energy(values_of(law), state), shear};
  default:
    return {coulomb_energy(state), shear};
  }
}

SpringEnergy SpringEnergies::of(const Contact& contact, const JointState* state) const {
  return state == nullptr ? of(0, state_of(contact, {}))
                          : of(laws_.number_of(state->law), state_of(contact, *state));
}

}  // namespace blocks::dynamics
