// The cards WATER and JWATER (docs/water.md).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "model/water.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/checks.hpp"
#include "run/builder/names.hpp"

namespace blocks::run {
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

/// Adds the points of the card to a table, in the order of their places. Returns false
/// after an error.
bool read_points(const Context& context, const deck::Water& card, WaterTable& table) {
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
    const Vec2& gravity = context.settings.gravity;
    const bool upright = gravity.x() == 0.0;
    context.error(
        card.x[i].where,
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

/// Warns if the table presses on nothing, or acts before the weight of blocks does.
void check_water(const Context& context, const deck::Water& card) {
  const Settings& settings = context.settings;
  const WaterTable& table = context.model.loads.water.table;
  if (card.n.value == 0 || context.diagnostics.has_errors() || !context.state.in_place)
    return;
  const GravityRamp& ramp = settings.gravity_ramp;
  if (ramp.duration > 0.0 && context.model.time < ramp.begin + ramp.duration &&
      card.tramp.value == 0.0)
    context.warning("the water acts at once, and gravity grows: blocks float first",
                    "give WATER after the ramp of gravity, with a tramp of its own");
  const Water later{table, {}};
  WaterNow water(later, context.model.time + table.duration);
  const Blocks& blocks = context.blocks;
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.is_removed(b) && water.on_block(blocks, b).acts)
      return;
  context.warning("the table lies below all blocks",
                  "gamma times the depth below the table presses on sides");
}

}  // namespace

void act(const Context& context, const deck::Water& card) {
  const Vec2& gravity = context.settings.gravity;
  WaterTable table;
  if (!gravity.isZero(0.0))
    table.up = -gravity.normalized();
  Water& water = context.model.loads.water;
  const double tramp = card.tramp.value;
  const bool has_table = WaterNow(water, context.model.time).has_table();
  const bool turned = has_table && (water.table.up - table.up).norm() > same;
  if (has_table && !turned)
    table.up = water.table.up;
  if (tramp > 0.0 && turned) {
    context.error(card.tramp.where,
                  "gravity has another direction than at the WATER card before",
                  "give the table without tramp");
    return;
  }
  if (tramp > 0.0 && has_table && card.n.value > 0 &&
      card.gamma.value != water.table.gamma) {
    context.error(card.gamma.where,
                  fmt::format("gamma is {:g} at the WATER card before, and cannot "
                              "change within tramp",
                              water.table.gamma),
                  "give the table without tramp");
    return;
  }
  if (!read_points(context, card, table))
    return;
  const double lowest = lowest_corner(context.blocks, table.up);
  if (table.none() && tramp > 0.0 && has_table) {
    table.place = {0.0};
    table.to = {lowest};  // it sinks there, and then all is dry
    table.drains = true;
  }
  table.from = table.to;
  table.gamma = card.n.value > 0 ? card.gamma.value : water.table.gamma;
  for (const double level : table.to)
    if (!std::isfinite(table.gamma * (std::abs(level) + std::abs(lowest)))) {
      context.error("the table is so far from the blocks that pressures overflow",
                    "give the table near the blocks");
      return;
    }
  if (tramp > 0.0 && !table.none()) {
    WaterTable before = has_table ? still(water, context.model.time) : WaterTable{};
    if (!has_table) {
      before.place = {0.0};
      before.to = before.from = {lowest};
    }
    table = changing(before, table, context.model.time, tramp);
  }
  water.table = table;
  check_water(context, card);
}

void check_direction_of_water(const Context& context) {
  const WaterTable& table = context.model.loads.water.table;
  const Vec2& gravity = context.settings.gravity;
  if (!table.none() && !gravity.isZero(0.0) &&
      (gravity.normalized() + table.up).norm() > same)
    context.warning("depth below the water table is not measured along this gravity",
                    "another WATER card takes the direction of gravity");
}

void act(const Context& context, const deck::Jwater& card) {
  const Blocks& blocks = context.blocks;
  const auto id = static_cast<int>(card.id.value);
  std::set<int> known;
  for (int c = 0; c < blocks.corners(); ++c)
    if (!blocks.is_removed(blocks.corner_block[c]))
      known.insert(blocks.joint[c]);
  for (const auto& [material, rule] : context.settings.crack_rules)
    known.insert(rule.joint);
  if (!known.contains(id) && !context.diagnostics.has_errors())
    context.error(card.id.where, fmt::format("no side has the joint id {}", id),
                  "put JWATER after the cards that make blocks; their joint ids: " +
                      listed(known));
  JointWater water{id,
                   {card.x1.value, card.y1.value},
                   {card.x2.value, card.y2.value},
                   card.p1.value,
                   card.p2.value,
                   card.reach.value,
                   context.model.time,
                   card.tramp.value};
  if (!card.reach.given) {
    constexpr double part_of_length = 0.01;
    water.reach = part_of_length * (water.b - water.a).norm();
  }
  const double square = (water.b - water.a).squaredNorm();
  if (card.presses() && !(square > 0.0 && std::isfinite(square))) {
    context.error("the two points are too near each other or too far apart",
                  "give the ends of the joint");
    return;
  }
  std::vector<JointWater>& all = context.model.loads.water.joints;
  if (!card.presses())
    std::erase_if(all, [&](const JointWater& one) { return one.joint == id; });
  all.push_back(water);
  if (!card.presses() || context.diagnostics.has_errors() || !context.state.in_place)
    return;
  const Water alone{{}, {water}};
  const WaterNow later(alone, context.model.time + water.duration);
  for (int c = 0; c < blocks.corners(); ++c)
    if (!blocks.is_removed(blocks.corner_block[c])) {
      const EndLoads loads = later.on_side(
          blocks.corner.col(c), blocks.corner.col(blocks.next[c]), blocks.joint[c]);
      if (loads.first > 0.0 || loads.second > 0.0)
        return;
    }
  context.warning(
      fmt::format(
          "no side of joint id {} lies between the points within {:.3g} of their "
          "line, so nothing is pressed",
          id, water.reach),
      "give points on the joint, or a larger reach");
}

}  // namespace blocks::run
