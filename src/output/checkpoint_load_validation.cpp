#include "output/checkpoint_load_validation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "output/checkpoint_expectations.hpp"

namespace blocks::output {

using namespace expectations;

namespace {

void expect_water(const Water& water) {
  const WaterTable& table = water.table;
  const auto points = static_cast<Eigen::Index>(table.place.size());
  expect("loads/water/gamma", table.gamma, points > 0 ? positive : not_negative);
  expect("loads/water/up", table.up);
  if (std::abs(table.up.norm() - 1.0) > 1e-12)
    reject_checkpoint("loads/water/up is no unit vector");
  for (const auto& [name, column] : {std::pair{"loads/water/place", &table.place},
                                     {"loads/water/from", &table.from},
                                     {"loads/water/to", &table.to}})
    expect_all(name, *column, points, finite);
  for (std::size_t i = 1; i < table.place.size(); ++i)
    if (!(table.place[i - 1] < table.place[i]))
      reject_checkpoint("loads/water/place does not increase");
  expect("loads/water/begin", table.begin, finite);
  expect("loads/water/duration", table.duration, not_negative);
  for (const JointWater& one : water.joints) {
    expect("loads/water/joints/joint", one.joint, not_negative);
    expect("loads/water/joints", one.a);
    expect("loads/water/joints", one.b);
    for (const double value : {one.p1, one.p2, one.reach, one.duration})
      expect("loads/water/joints", value, not_negative);
    expect("loads/water/joints/begin", one.begin, finite);
    if (!one.is_dry() && one.a == one.b)
      reject_checkpoint("loads/water/joints has a pressure at one point");
  }
}

}  // namespace

void expect_loads(const Loads& loads, const Blocks& b) {
  expect_water(loads.water);
  const auto points = static_cast<Eigen::Index>(loads.function.t.size());
  expect_all("loads/function/t", loads.function.t, points, finite);
  expect_all("loads/function/p", loads.function.p, points, finite);
  for (std::size_t i = 1; i < loads.function.t.size(); ++i)
    if (!(loads.function.t[i - 1] <= loads.function.t[i]))
      reject_checkpoint("loads/function/t decreases");
  for (const Pressure& pressure : loads.pressures) {
    expect_index("loads/pressures/block", pressure.block, b.size());
    expect_index("loads/pressures/side", pressure.side, b.corners_of(pressure.block));
    for (const double value : {pressure.p1, pressure.p2, pressure.arrival})
      expect("loads/pressures", value, finite);
  }
  for (const CentroidForce& force : loads.forces) {
    expect_index("loads/forces/block", force.block, b.size());
    expect("loads/forces", force.force);
    expect("loads/forces/arrival", force.arrival, finite);
  }
  for (const QuietSide& quiet : loads.quiet_sides) {
    expect_index("loads/quiet_sides/block", quiet.block, b.size());
    expect_index("loads/quiet_sides/side", quiet.side, b.corners_of(quiet.block));
    for (const double speed : {quiet.cp, quiet.cs})
      expect("loads/quiet_sides", speed, positive);
    for (const Vec2& force : {quiet.first, quiet.second})
      expect("loads/quiet_sides", force);
  }
  const bool needs_function =
      !loads.pressures.empty() ||
      std::any_of(loads.forces.begin(), loads.forces.end(),
                  [](const CentroidForce& force) { return !force.is_constant(); });
  if (loads.function.empty() && needs_function)
    reject_checkpoint("loads without a function of time");
}

}  // namespace blocks::output
