#include "post/read/frame_quantity.hpp"

#include <set>
#include <stdexcept>

namespace blocks::post {

using namespace draw;

using quantities::BlockStates;
using quantities::ContactState;
using quantities::Corners;
using quantities::find_other;
using quantities::find_quantity;

BlockStates states_of(const Frame& f) {
  return {{f.centroid, Corners(f.outlines)},
          f.velocity,
          f.force,
          f.angle,
          f.spin,
          f.moment,
          f.area,
          f.mass,
          f.inertia,
          f.stress,
          f.applied,
          f.strain_rate,
          f.material,
          nullptr,
          &f.fixed,
          f.unbalanced.size() > 0 ? &f.unbalanced : nullptr,
          f.local_ratio.size() > 0 ? &f.local_ratio : nullptr,
          f.water_force.size() > 0 ? &f.water_force : nullptr};
}

std::vector<ContactState> states_of(const FrameContacts& contacts) {
  std::vector<ContactState> states;
  for (int i = 0; i < contacts.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    states.push_back({contacts.corner_block[k], contacts.edge_block[k],
                      contacts.normal_force[i], contacts.shear_force[i],
                      contacts.overlap[i]});
    if (!contacts.states.empty() && contacts.states[k].law != 0)
      states.back().state = contacts.states[k];
  }
  return states;
}

std::string no_unbalanced_text() {
  return "the results have no unbalanced forces\n  hint: a run writes them if its deck "
         "has SOLVE, LOCDAMP or KINDAMP, or a HISTORY of unbalanced";
}

Eigen::VectorXd values_of(const QuantityKind& kind, const Frame& now,
                          const Frame& first) {
  if (quantities::is_of_equilibrium(kind.name) && now.unbalanced.size() == 0)
    throw std::runtime_error(no_unbalanced_text());
  const BlockStates states = states_of(now), before = states_of(first);
  Eigen::VectorXd values(now.centroid.cols());
  for (int b = 0; b < values.size(); ++b)
    values[b] = kind.value(states, before, b);
  return values;
}

namespace {

Zero zero_of(const QuantityKind& kind) {
  static const std::set<std::string> magnitudes = {
      "speed", "displacement", "unbalanced", "local_ratio", "kinetic_energy"};
  return kind.is_signed                   ? Zero::middle
         : magnitudes.contains(kind.name) ? Zero::lowest
                                          : Zero::none;
}

}  // namespace

std::string sign_convention(const QuantityKind& kind, bool compression_positive) {
  if (!is_stress(kind))
    return "";
  return compression_positive ? ", compression positive" : ", tension positive";
}

bool is_internal_stress(const QuantityKind& kind) {
  return is_stress(kind) && !kind.label.starts_with("applied");
}

bool is_odd(const std::string& name) {
  static const std::set<std::string> odd = {
      "dx",  "vx",  "fx",  "momentum_x", "rotation",        "spin", "moment", "s12",
      "s21", "a12", "a21", "e12",        "angular_momentum"};
  const QuantityKind* kind = find_quantity(name);
  return kind && odd.contains(kind->name);
}

Eigen::VectorXd in_mirror(const std::string& name, const Eigen::VectorXd& values,
                          double plane) {
  const QuantityKind* kind = find_quantity(name);
  if (kind && kind->name == "x")
    return 2.0 * plane - values.array();
  return is_odd(name) ? Eigen::VectorXd(-values) : values;
}

Quantity quantity(const std::string& name, const Frame& now, const Frame& first,
                  const FrameContacts& contacts) {
  if (const QuantityKind* kind = find_quantity(name))
    return {kind->label + sign_convention(*kind, now.compression_positive),
            kind->dimension, values_of(*kind, now, first), zero_of(*kind),
            quantities::is_of_equilibrium(kind->name)};
  if (const quantities::OtherKind* kind = find_other(name); kind && kind->contact) {
    Eigen::VectorXd values(now.size());
    kind->of_contacts(states_of(contacts),
                      {values.data(), static_cast<std::size_t>(values.size())});
    return {kind->label, kind->dimension, values, Zero::lowest};
  }
  const std::string near = quantities::nearest_quantity(
      name, {"material", "family", "joint", "bond", "opening", "shear_displacement",
             "water_pressure"});
  throw std::runtime_error("there is no quantity '" + name +
                           (near.empty()
                                ? "': choose material, family, joint, bond, opening, "
                                  "shear_displacement, water_pressure, " +
                                      quantities::block_quantity_names()
                                : "'; did you mean " + near + "?"));
}

}  // namespace blocks::post
