#include "dynamics/contacts/law_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blocks::dynamics {
namespace {

LawBits bit_of(LawKind kind) {
  switch (kind) {
  case LawKind::walton:
    return walton_bit;
  case LawKind::barton:
    return barton_bit;
  case LawKind::coulomb:
    break;
  }
  return coulomb_bit;
}

/// Returns kni or, for other laws, kn.
double stiffness_of(const JointLaw& law) {
  return law.kind == LawKind::barton ? law.initial_stiffness : law.normal_stiffness;
}

/// Returns the closure at which the tangent kni / (1 - V / vm)^2 reaches knmax, [L].
double linear_from(const JointLaw& law) {
  if (law.kind != LawKind::barton)
    return 0.0;
  return law.largest_closure *
         (1.0 - std::sqrt(law.initial_stiffness / law.largest_stiffness));
}

}  // namespace

bool LawTable::is_of(const Settings& settings) const {
  if (settings.joint_laws.empty() && !settings.in_situ)
    return none();
  return in_situ_ == settings.in_situ && friction_ == settings.friction &&
         laws_ == settings.joint_laws && of_materials_ == settings.joint_of_materials;
}

void LawTable::make(const Settings& settings, const Blocks& blocks) {
  laws_ = settings.joint_laws;
  of_materials_ = settings.joint_of_materials;
  friction_ = settings.friction;
  in_situ_ = settings.in_situ;
  ids_.assign(1, 0);
  for (const auto& [id, law] : laws_)
    ids_.push_back(id);
  block_has_.assign(laws_.empty() ? 0 : static_cast<std::size_t>(blocks.size()), 0);
  if (none())
    return;
  for (int c = 0; c < blocks.corners(); ++c)
    if (number_of(blocks.joint[c]) != 0)
      block_has_[blocks.corner_block[c]] = 1;

  std::vector<JointLaw> all(1);
  all[0].friction = all[0].residual_friction = friction_;
  for (const auto& [id, law] : laws_)
    all.push_back(law);
  numbers_.clear();
  constexpr std::size_t columns = 19;
  numbers_.reserve(columns * all.size());
  const auto column = [&](const auto& value) {
    const double* const begin = numbers_.data() + numbers_.size();
    for (const JointLaw& law : all)
      numbers_.push_back(value(law));
    return begin;
  };
  const auto member = [&](double JointLaw::*value) {
    return column([&](const JointLaw& law) { return law.*value; });
  };
  LawValues<const double*>& values = columns_.values;
  values.friction = member(&JointLaw::friction);
  values.cohesion = member(&JointLaw::cohesion);
  values.tension = member(&JointLaw::tension);
  values.residual_friction = member(&JointLaw::residual_friction);
  values.residual_cohesion = member(&JointLaw::residual_cohesion);
  values.residual_tension = member(&JointLaw::residual_tension);
  values.dilation = member(&JointLaw::dilation);
  values.dilation_limit = member(&JointLaw::dilation_limit);
  values.unloading_ratio = column(
      [](const JointLaw& law) { return 1.0 / (law.restitution * law.restitution); });
  values.roughness = member(&JointLaw::roughness);
  values.wall_strength = member(&JointLaw::wall_strength);
  values.residual_angle = column([](const JointLaw& law) {
    return law.residual_angle * std::numbers::pi / 180.0;
  });
  values.peak_slip = member(&JointLaw::peak_slip);
  values.largest_closure = member(&JointLaw::largest_closure);
  values.linear_from = column(linear_from);
  values.strength_share = member(&JointLaw::strength_share);
  columns_.normal_stiffness = column(stiffness_of);
  columns_.shear_stiffness = member(&JointLaw::shear_stiffness);
  columns_.bit =
      column([](const JointLaw& law) { return static_cast<double>(bit_of(law.kind)); });
}

int LawTable::number_of(int id) const {
  const auto found = std::lower_bound(ids_.begin() + 1, ids_.end(), id);
  return found != ids_.end() && *found == id ? static_cast<int>(found - ids_.begin())
                                             : 0;
}

int LawTable::law_of(const Blocks& blocks, int corner, int edge) const {
  if (laws_.empty())
    return 0;
  const int id = blocks.joint[edge];
  if (id != 0 &&
      (blocks.joint[corner] == id || blocks.joint[blocks.previous[corner]] == id))
    if (const int law = number_of(id); law != 0)
      return law;
  const auto pair = std::minmax(blocks.material[blocks.corner_block[corner]],
                                blocks.material[blocks.corner_block[edge]]);
  const auto found = of_materials_.find({pair.first, pair.second});
  return found == of_materials_.end() ? 0 : number_of(found->second);
}

bool LawTable::may_act(const Blocks& blocks, int low, int high) const {
  if (in_situ_)
    return true;
  if (none())
    return false;
  if (block_has_[low] != 0 && block_has_[high] != 0)
    return true;
  const auto pair = std::minmax(blocks.material[low], blocks.material[high]);
  return of_materials_.contains({pair.first, pair.second});
}

}  // namespace blocks::dynamics
