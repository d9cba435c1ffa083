#include "output/checkpoint/checkpoint_expectations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace blocks::output {

namespace {

/// Expects values that JOINT, WALTON and BARTON allow.
void expect_law(int id, const JointLaw& law) {
  const auto expect_value = [&](const std::string& name, double value,
                                const Range& range) {
    if (!range.holds(value))
      expect(fmt::format("settings/joint_laws: {} of id {}", name, id), value, range);
  };
  for (const auto& [name, peak, residual] :
       {std::tuple{"friction", law.friction, law.residual_friction},
        {"cohesion", law.cohesion, law.residual_cohesion},
        {"tension", law.tension, law.residual_tension}})
    expect_value(fmt::format("residual {}", name), residual,
                 {0.0, peak, "at most the peak value"});
  expect_value("dilation", law.dilation,
               {0.0, law.residual_friction, "at most the residual friction"});
  constexpr Range zero{0.0, 0.0, "0"};
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
    expect_value(name, value, law.kind == LawKind::barton ? range : zero);
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

void expect_law_states(const Model& model) {
  const std::vector<LawState>& states = model.law_states;
  const auto bonds =
      std::count_if(states.begin(), states.end(), [](const LawState& state) {
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
  expect_rows("joint_states", states, std::ssize(model.contacts));
  for (const LawState& state : states)
    if (state.law != 0 && !model.settings.joint_laws.contains(state.law))
      reject_checkpoint(
          fmt::format("joint_states names joint id {}, which has no law", state.law));
}

void expect_drives(const Model& model) {
  const Blocks& b = model.blocks;
  expect_ascending("drive", model.drives, &Drive::block);
  for (const Drive& drive : model.drives) {
    if (!b.is_driven(drive.block))
      reject_checkpoint(
          fmt::format("drives names block {}, which is not driven", drive.block + 1));
    if (b.velocity.col(drive.block) != drive.velocity ||
        b.spin[drive.block] != drive.spin)
      reject_checkpoint(
          fmt::format("block {} has not the velocity of its drive", drive.block + 1));
  }
  expect_ascending("servo", model.servos, &Servo::block);
  for (const Servo& servo : model.servos) {
    expect_index("servos/side", servo.side, b.corners_of(servo.block));
    const auto is_its_drive = [&](const Drive& drive) {
      return drive.block == servo.block;
    };
    if (std::none_of(model.drives.begin(), model.drives.end(), is_its_drive))
      reject_checkpoint(
          fmt::format("servos names block {}, which has no drive", servo.block + 1));
  }
}

}  // namespace blocks::output
