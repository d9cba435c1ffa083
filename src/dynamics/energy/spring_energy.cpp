#include "dynamics/energy/spring_energy.hpp"

#include "dynamics/kernels/laws.hpp"

namespace blocks::dynamics {

ContactState<double> state_of(const Contact& contact, const LawState& state) {
  ContactState<double> now;
  now.normal = contact.normal_elastic, now.shear = contact.shear_elastic;
  each_state([](double& to, auto from) { to = static_cast<double>(from); }, now, state);
  return now;
}

SpringEnergies::SpringEnergies(const Settings& settings, const LawTable& laws)
    : settings_(settings), laws_(laws) {}

SpringEnergy SpringEnergies::of(int law, ContactState<double> state) const {
  if (!(state.stiffness > 0.0)) {
    state.stiffness = settings_.normal_stiffness;
    state.shear_stiffness = settings_.shear_stiffness;
  }
  double normal = 0.0;
  each_law(laws_.bit(law), [&]<LawBits kind>(std::integral_constant<LawBits, kind>) {
    normal = normal_energy<kind>(laws_.values(law), state);
  });
  return {normal, shear_energy(state)};
}

SpringEnergy SpringEnergies::of(const Contact& contact, const LawState* state) const {
  return state == nullptr ? of(0, state_of(contact, {}))
                          : of(laws_.number_of(state->law), state_of(contact, *state));
}

}  // namespace blocks::dynamics
