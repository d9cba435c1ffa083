// The cards WATER and JWATER (docs/water.md).
#include "run/builder/builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "model/water.hpp"

namespace blocks::run {

using deck::Command;

namespace {

/// Returns the lowest height of a corner of the present blocks, [L]; 0 without blocks.
double lowest_corner(const Blocks& blocks, const Vec2& up) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int c = 0; c < blocks.corners(); ++c)
    if (!blocks.is_removed(blocks.corner_block[c]))
      lowest = std::min(lowest, up.dot(Vec2(blocks.corner.col(c))));
  return std::isfinite(lowest) ? lowest : 0.0;
}

/// The levels of a table at one time, as points.
WaterTable still(const Water& water, double time) {
  WaterTable table = water.table;
  const WaterNow now(water, time);
  for (std::size_t k = 0; k < table.place.size(); ++k)
    table.to[k] = now.level_at(table.place[k]);
  table.from = table.to;
  table.duration = 0.0;
  return table;
}

/// Lets a table change from one to another from `begin` on. Both have points and the
/// same directions.
WaterTable changing(const WaterTable& from, const WaterTable& to, double begin,
                    double duration) {
  WaterTable table = to;
  std::set<double> places(from.place.begin(), from.place.end());
  places.insert(to.place.begin(), to.place.end());
  table.place.assign(places.begin(), places.end());
  table.from.clear(), table.to.clear();
  const Water old{from, {}}, wanted{to, {}};
  for (const double s : table.place) {
    table.from.push_back(WaterNow(old, begin).level_at(s));
    table.to.push_back(WaterNow(wanted, begin).level_at(s));
  }
  table.begin = begin;
  table.duration = duration;
  return table;
}

constexpr double same = 1e-9;  // of directions

std::string listed(const std::set<int>& ids) {
  return ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, ", "));
}

}  // namespace

bool Builder::read_points(const Command& command, const deck::Water& card,
                          WaterTable& table) {
  const Vec2 across = table.across();
  for (std::size_t i = 0; i < card.x.size(); ++i) {
    const Vec2 at(card.x[i].value, card.y[i].value);
    table.place.push_back(across.dot(at));
    table.to.push_back(table.up.dot(at));
  }
  const std::vector<double>& place = table.place;
  const bool leftwards = place.size() > 1 && place[1] < place[0];
  for (std::size_t i = 1; i < place.size(); ++i) {
    const double step = place[i] - place[i - 1];
    if (leftwards ? step < 0.0 : step > 0.0)
      continue;
    const Vec2& gravity = model_.settings.gravity;
    const bool upright = gravity.x() == 0.0;
    diagnostics_.error(
        card.x[i].where, command.name,
        upright ? "the points of the table must follow each other in x"
                : "the points of the table must follow each other across gravity",
        upright ? fmt::format("a water table is a function of x; the point before has "
                              "x = {:g}",
                              card.x[i - 1].value)
                : fmt::format("gravity is ({:g}, {:g}) here, and depth is measured "
                              "along it",
                              gravity.x(), gravity.y()));
    return false;
  }
  if (leftwards) {
    std::reverse(table.place.begin(), table.place.end());
    std::reverse(table.to.begin(), table.to.end());
  }
  return true;
}

void Builder::set_water(const Command& command, const deck::Water& card) {
  const Vec2& gravity = model_.settings.gravity;
  WaterTable table;
  if (!gravity.isZero(0.0))
    table.up = -gravity.normalized();
  Water& water = model_.loads.water;
  const double tramp = card.tramp.value;
  const bool has_table = WaterNow(water, model_.time).has_table();
  const bool turned = has_table && (water.table.up - table.up).norm() > same;
  if (has_table && !turned)
    table.up = water.table.up;
  if (tramp > 0.0 && turned) {
    diagnostics_.error(card.tramp.where, command.name,
                       "gravity has another direction than at the WATER card before",
                       "give the table without tramp");
    return;
  }
  if (tramp > 0.0 && has_table && card.n.value > 0 &&
      card.gamma.value != water.table.gamma) {
    diagnostics_.error(card.gamma.where, command.name,
                       fmt::format("gamma is {:g} at the WATER card before, and cannot "
                                   "change within tramp",
                                   water.table.gamma),
                       "give the table without tramp");
    return;
  }
  if (!read_points(command, card, table))
    return;
  const double lowest = lowest_corner(model_.blocks, table.up);
  if (table.none() && tramp > 0.0 && has_table) {
    table.place = {0.0};
    table.to = {lowest};  // it sinks there, and then all is dry
    table.drains = true;
  }
  table.from = table.to;
  table.gamma = card.n.value > 0 ? card.gamma.value : water.table.gamma;
  for (const double level : table.to)
    if (!std::isfinite(table.gamma * (std::abs(level) + std::abs(lowest)))) {
      diagnostics_.error(command.where, command.name,
                         "the table is so far from the blocks that pressures overflow",
                         "give the table near the blocks");
      return;
    }
  if (tramp > 0.0 && !table.none()) {
    WaterTable before = has_table ? still(water, model_.time) : WaterTable{};
    if (!has_table) {
      before.place = {0.0};
      before.to = before.from = {lowest};
    }
    table = changing(before, table, model_.time, tramp);
  }
  water.table = table;
  check_water(command, card);
}

void Builder::check_water(const Command& command, const deck::Water& card) {
  const Settings& settings = model_.settings;
  const WaterTable& table = model_.loads.water.table;
  if (card.n.value == 0 || diagnostics_.has_errors() || !in_place_)
    return;
  const GravityRamp& ramp = settings.gravity_ramp;
  if (ramp.duration > 0.0 && model_.time < ramp.begin + ramp.duration &&
      card.tramp.value == 0.0)
    diagnostics_.warning(
        command.where, command.name,
        "the water acts at once, and gravity grows: blocks float first",
        "give WATER after the ramp of gravity, with a tramp of its own");
  const Water later{table, {}};
  WaterNow water(later, model_.time + table.duration);
  const Blocks& blocks = model_.blocks;
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.is_removed(b) && water.on_block(blocks, b).acts)
      return;
  diagnostics_.warning(command.where, command.name, "the table lies below all blocks",
                       "gamma times the depth below the table presses on sides");
}

void Builder::check_direction_of_water(const Command& command) {
  const WaterTable& table = model_.loads.water.table;
  const Vec2& gravity = model_.settings.gravity;
  if (!table.none() && !gravity.isZero(0.0) &&
      (gravity.normalized() + table.up).norm() > same)
    diagnostics_.warning(
        command.where, command.name,
        "depth below the water table is not measured along this gravity",
        "another WATER card takes the direction of gravity");
}

void Builder::set_joint_water(const Command& command, const deck::Jwater& card) {
  const Blocks& blocks = model_.blocks;
  const auto id = static_cast<int>(card.id.value);
  std::set<int> known;
  for (int c = 0; c < blocks.corners(); ++c)
    if (!blocks.is_removed(blocks.corner_block[c]))
      known.insert(blocks.joint[c]);
  for (const auto& [material, rule] : model_.settings.crack_rules)
    known.insert(rule.joint);
  if (!known.contains(id) && !diagnostics_.has_errors())
    diagnostics_.error(
        card.id.where, command.name, fmt::format("no side has the joint id {}", id),
        "put JWATER after the cards that make blocks; their joint ids: " +
            listed(known));
  JointWater water{id,
                   {card.x1.value, card.y1.value},
                   {card.x2.value, card.y2.value},
                   card.p1.value,
                   card.p2.value,
                   card.reach.value,
                   model_.time,
                   card.tramp.value};
  if (!card.reach.given) {
    constexpr double part_of_length = 0.01;
    water.reach = part_of_length * (water.b - water.a).norm();
  }
  const double square = (water.b - water.a).squaredNorm();
  if (card.presses() && !(square > 0.0 && std::isfinite(square))) {
    diagnostics_.error(command.where, command.name,
                       "the two points are too near each other or too far apart",
                       "give the ends of the joint");
    return;
  }
  std::vector<JointWater>& all = model_.loads.water.joints;
  if (!card.presses())
    std::erase_if(all, [&](const JointWater& one) { return one.joint == id; });
  all.push_back(water);
  if (!card.presses() || diagnostics_.has_errors() || !in_place_)
    return;
  const Water alone{{}, {water}};
  const WaterNow later(alone, model_.time + water.duration);
  for (int c = 0; c < blocks.corners(); ++c)
    if (!blocks.is_removed(blocks.corner_block[c])) {
      const EndLoads loads = later.on_side(
          blocks.corner.col(c), blocks.corner.col(blocks.next[c]), blocks.joint[c]);
      if (loads.first > 0.0 || loads.second > 0.0)
        return;
    }
  diagnostics_.warning(
      command.where, command.name,
      fmt::format(
          "no side of joint id {} lies between the points within {:.3g} of their "
          "line, so nothing is pressed",
          id, water.reach),
      "give points on the joint, or a larger reach");
}

}  // namespace blocks::run
