#include "dynamics/contacts/law_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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

/// Returns the values that the kernels need.
LawValues<double> values_of(const JointLaw& law) {
  LawValues<double> values = {};
  values.friction = law.friction, values.residual_friction = law.residual_friction;
  values.cohesion = law.cohesion, values.residual_cohesion = law.residual_cohesion;
  values.tension = law.tension, values.residual_tension = law.residual_tension;
  values.dilation = law.dilation, values.dilation_limit = law.dilation_limit;
  values.unloading_ratio = 1.0 / (law.restitution * law.restitution);
  values.roughness = law.roughness, values.wall_strength = law.wall_strength;
  values.residual_angle = law.residual_angle * std::numbers::pi / 180.0;
  values.peak_slip = law.peak_slip, values.strength_share = law.strength_share;
  values.largest_closure = law.largest_closure;
  const bool is_barton = law.kind == LawKind::barton;
  // where the tangent kni / (1 - V / vm)^2 reaches knmax
  values.linear_from =
      is_barton ? law.largest_closure *
                      (1.0 - std::sqrt(law.initial_stiffness / law.largest_stiffness))
                : 0.0;
  values.normal_stiffness = is_barton ? law.initial_stiffness : law.normal_stiffness;
  values.shear_stiffness = law.shear_stiffness;
  return values;
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
  for (int c = 0; c < blocks.corners() && !laws_.empty(); ++c)
    if (number_of(blocks.joint[c]) != 0)
      block_has_[blocks.corner_block[c]] = 1;

  JointLaw usual;
  usual.friction = usual.residual_friction = friction_;
  values_.assign(1, values_of(usual));
  bits_.assign(1, coulomb_bit);
  for (const auto& [id, law] : laws_)
    values_.push_back(values_of(law)), bits_.push_back(bit_of(law.kind));

  // Column by column: the values, then the bits.
  const std::size_t count = values_.size();
  constexpr std::size_t columns = sizeof(LawValues<double>) / sizeof(double) + 1;
  numbers_.resize(columns * count);
  for (std::size_t law = 0; law < count; ++law) {
    double* to = &numbers_[law];
    const auto put = [&](double value) { *std::exchange(to, to + count) = value; };
    each_value(put, values_[law]);
    put(bits_[law]);
  }
  const double* begin = numbers_.data();
  const auto take = [&](const double*& column) {
    column = std::exchange(begin, begin + count);
  };
  each_value(take, columns_.values);
  take(columns_.kind);
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
