#include <algorithm>
#include <cmath>

#include "output/checkpoint/checkpoint_expectations.hpp"

namespace blocks::output {
namespace {

void expect_water(const Water& water) {
  const WaterTable& table = water.table;
  if (!table.place.empty())
    expect("loads/water/gamma", table.gamma, positive);
  if (std::abs(table.up.norm() - 1.0) > 1e-12)
    reject_checkpoint("loads/water/up is no unit vector");
  expect_rows("loads/water/from", table.from, std::ssize(table.place));
  expect_rows("loads/water/to", table.to, std::ssize(table.place));
  expect_ascending("loads/water/place: value", table.place);
  for (const JointWater& one : water.joints)
    if (!one.is_dry() && one.a == one.b)
      reject_checkpoint("loads/water/joints has a pressure at one point");
}

}  // namespace

void expect_loads(const Loads& loads, const Blocks& blocks) {
  expect_water(loads.water);
  const TimeFunction& function = loads.function;
  expect_rows("loads/function/p", function.p, std::ssize(function.t));
  if (!std::is_sorted(function.t.begin(), function.t.end()))
    reject_checkpoint("loads/function/t decreases");
  for (const Pressure& pressure : loads.pressures)
    expect_index("loads/pressures/side", pressure.side,
                 blocks.corners_of(pressure.block));
  for (const QuietSide& quiet : loads.quiet_sides)
    expect_index("loads/quiet_sides/side", quiet.side, blocks.corners_of(quiet.block));
  const bool needs_function =
      !loads.pressures.empty() ||
      std::any_of(loads.forces.begin(), loads.forces.end(),
                  [](const CentroidForce& force) { return !force.is_constant(); });
  if (function.empty() && needs_function)
    reject_checkpoint("loads without a function of time");
}

}  // namespace blocks::output
