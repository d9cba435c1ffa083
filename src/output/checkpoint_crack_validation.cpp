#include "output/checkpoint_crack_validation.hpp"

#include <fmt/format.h>

#include "output/checkpoint_expectations.hpp"

namespace blocks::output {

using namespace expectations;

namespace {

constexpr int causes = 2;  // of CrackCause

}  // namespace

void expect_cracks(const Model& model) {
  for (const auto& [material, rule] : model.settings.crack_rules) {
    if (!model.settings.materials.contains(material))
      reject_checkpoint(fmt::format("settings/crack_rules: no material {}", material));
    for (const double value : {rule.strength, rule.least_area})
      expect("settings/crack_rules", value, positive);
    expect("settings/crack_rules/point_strength", rule.point_strength, not_negative);
    expect("settings/crack_rules/joint", rule.joint, not_negative);
  }
  int last = 0;  // new blocks have ascending numbers
  for (const CrackRecord& crack : model.cracks) {
    expect_index("cracks/parent", crack.parent, model.blocks.size());
    expect_index("cracks/child", crack.child, model.blocks.size());
    expect_index("cracks/cause", static_cast<int>(crack.cause), causes);
    if (crack.child <= last)
      reject_checkpoint(fmt::format("block {} split off twice", crack.child + 1));
    last = crack.child;
    for (const double value : {static_cast<double>(crack.step), crack.time, crack.moved,
                               crack.kinetic_before, crack.kinetic_after,
                               crack.strain_before, crack.strain_after})
      expect("cracks", value, not_negative);
    for (const double value : {crack.stress, crack.parent_area, crack.child_area})
      expect("cracks", value, positive);
    for (const Vec2& end : {crack.from, crack.to})
      expect("cracks", end);
  }
  for (std::size_t i = 0; i < model.crack_refusals.size(); ++i) {
    const RefusedCrack& refused = model.crack_refusals[i];
    expect_index("crack_refusals/block", refused.block, model.blocks.size());
    expect_index("crack_refusals/why", static_cast<int>(refused.why), crack_refusals);
    if (i > 0 && !(model.crack_refusals[i - 1] < refused))
      reject_checkpoint(fmt::format("refused crack {} is out of order", i + 1));
  }
}

}  // namespace blocks::output
