#include "output/checkpoint_law_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "output/checkpoint_expectations.hpp"

namespace blocks::output {

using namespace expectations;

namespace {

/// Expects values that JOINT, WALTON and BARTON allow.
void expect_law(int id, const JointLaw& law) {
  const auto expect_value = [&](const std::string& name, double value,
                                const Range& range) {
    if (!holds(range, value))
      expect(fmt::format("settings/joint_laws: {} of id {}", name, id), value, range);
  };
  expect_value("id", id, positive);
  expect_value("kind", static_cast<double>(law.kind), {0.0, 2.0, "0, 1 or 2"});
  for (const auto& [name, peak, residual] :
       {std::tuple{"friction", law.friction, law.residual_friction},
        {"cohesion", law.cohesion, law.residual_cohesion},
        {"tension", law.tension, law.residual_tension}}) {
    expect_value(name, peak, not_negative);
    expect_value(fmt::format("residual {}", name), residual,
                 {0.0, peak, "at most the peak value"});
  }
  expect_value("dilation", law.dilation,
               {0.0, law.residual_friction, "at most the residual friction"});
  expect_value("dilation_limit", law.dilation_limit,
               {0.0, infinite, "a number above 0", true});
  expect_value("normal_stiffness", law.normal_stiffness, not_negative);
  expect_value("shear_stiffness", law.shear_stiffness, not_negative);
  expect_value("restitution", law.restitution,
               {0.0, 1.0, "a number above 0, up to 1", true});
  expect_value("strength_share", law.strength_share, positive);
  constexpr Range zero{0.0, 0.0, "0"};
  const bool is_rough = law.kind == LawKind::barton;
  if (law.kind != LawKind::coulomb) {
    expect_value("tension", law.tension, zero);
    expect_value("dilation", law.dilation, zero);
  }
  for (const auto& [name, value, range] :
       {std::tuple{"roughness", law.roughness,
                   Range{0.0, 20.0, "a number above 0, up to 20", true}},
        {"wall_strength", law.wall_strength, positive},
        {"residual_angle", law.residual_angle,
         Range{0.0, 70.0, "a number above 0, up to 70", true}},
        {"peak_slip", law.peak_slip, positive},
        {"initial_stiffness", law.initial_stiffness, positive},
        {"largest_closure", law.largest_closure, positive},
        {"largest_stiffness", law.largest_stiffness, positive}})
    expect_value(name, value, is_rough ? range : zero);
  expect_value("largest_stiffness", law.largest_stiffness,
               {law.initial_stiffness, largest, "at least the initial stiffness"});
}

}  // namespace

void expect_laws(const Settings& s) {
  for (const auto& [id, law] : s.joint_laws)
    expect_law(id, law);
  for (const auto& [pair, id] : s.joint_of_materials) {
    if (!s.materials.contains(pair.first) || !s.materials.contains(pair.second) ||
        pair.first > pair.second)
      reject_checkpoint(
          fmt::format("settings/joint_of_materials names materials {} and {}",
                      pair.first, pair.second));
    if (!s.joint_laws.contains(id))
      reject_checkpoint(fmt::format("settings/joint_of_materials names joint id {}, "
                                    "which has no law",
                                    id));
  }
}

void expect_joint_states(const Model& model) {
  const std::vector<JointState>& states = model.joint_states;
  const auto bonds =
      std::count_if(states.begin(), states.end(), [](const JointState& state) {
        return state.bonded && !state.failed;
      });
  if (model.bonds_made < bonds)
    reject_checkpoint(fmt::format("bonds_made is {}, expected at least {}, the number "
                                  "of intact bonds",
                                  model.bonds_made, bonds));
  if (states.empty())
    return;
  if (model.settings.joint_laws.empty() && !model.settings.in_situ)
    reject_checkpoint("joint_states without settings/joint_laws");
  if (states.size() != model.contacts.size())
    reject_checkpoint(fmt::format("joint_states has {} rows, expected {}",
                                  states.size(), model.contacts.size()));
  for (std::size_t i = 0; i < states.size(); ++i) {
    const JointState& state = states[i];
    if (state.law != 0 && !model.settings.joint_laws.contains(state.law))
      reject_checkpoint(
          fmt::format("joint_states names joint id {}, which has no law", state.law));
    each_joint_field([&](const JointField& field, auto member) {
      const double value = state.*member;
      const Range& range = field.range == StateRange::finite ? finite : not_negative;
      if (!holds(range, value))
        expect(fmt::format("joint_states {}: {}", i + 1, field.name), value, range);
    });
  }
}

void expect_drives(const Model& model) {
  const Blocks& b = model.blocks;
  for (std::size_t i = 0; i < model.drives.size(); ++i) {
    const Drive& drive = model.drives[i];
    expect_index("drives/block", drive.block, b.size());
    expect("drives/velocity", drive.velocity);
    expect("drives/spin", drive.spin, finite);
    if (i > 0 && model.drives[i - 1].block >= drive.block)
      reject_checkpoint(fmt::format("drive {} is out of order", i + 1));
    if (!b.is_driven(drive.block))
      reject_checkpoint(
          fmt::format("drives names block {}, which is not driven", drive.block + 1));
    if (b.velocity.col(drive.block) != drive.velocity ||
        b.spin[drive.block] != drive.spin)
      reject_checkpoint(
          fmt::format("block {} has not the velocity of its drive", drive.block + 1));
  }
  for (std::size_t i = 0; i < model.servos.size(); ++i) {
    const Servo& servo = model.servos[i];
    expect_index("servos/block", servo.block, b.size());
    expect_index("servos/side", servo.side, b.corners_of(servo.block));
    expect("servos/target", servo.target, finite);
    expect("servos/most", servo.most, positive);
    if (i > 0 && model.servos[i - 1].block >= servo.block)
      reject_checkpoint(fmt::format("servo {} is out of order", i + 1));
    const auto is_its_drive = [&](const Drive& drive) {
      return drive.block == servo.block;
    };
    if (std::none_of(model.drives.begin(), model.drives.end(), is_its_drive))
      reject_checkpoint(
          fmt::format("servos names block {}, which has no drive", servo.block + 1));
  }
}

}  // namespace blocks::output
