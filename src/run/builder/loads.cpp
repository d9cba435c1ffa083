// GRAVITY, FUNCTION, PRESSBC and FORCE.
#include <fmt/format.h>

#include "run/builder/cards.hpp"
#include "run/builder/checks.hpp"
#include "run/builder/selectors.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

/// [F/L^2] at the two corners of a side.
struct CornerPressures {
  double first, second;
};

/// Returns whether there is a FUNCTION card. Reports an error if not.
bool has_function(const Context& context) {
  if (context.model.loads.function.empty() && !context.state.unread.has("FUNCTION") &&
      !context.state.unread.has("RESTART"))
    context.error(
        "no FUNCTION card was given, so the load has no time history",
        "add FUNCTION, ntimep among the preliminary cards, followed by ntimep "
        "lines t, p");
  return !context.model.loads.function.empty();
}

}  // namespace

void act(const Context& context, const deck::Gravity& card) {
  Settings& settings = context.settings;
  const double now = context.model.time;
  settings.gravity_ramp = {settings.gravity_at(now), now, card.tramp.value};
  settings.gravity = {card.gravx.value, card.gravy.value};
  check_direction_of_water(context);
}

void act(const Context& context, const deck::Function& card) {
  auto& function = context.model.loads.function;
  for (const deck::Real& t : card.t)
    function.t.push_back(t.value);
  for (const deck::Real& p : card.p)
    function.p.push_back(p.value);
  for (std::size_t i = 1; i < card.t.size(); ++i)
    if (card.t[i - 1].value == card.t[i].value)
      context.state.notes.push_back(fmt::format(
          "FUNCTION in line {}: a step from {:g} to {:g} at t = {:g}",
          card.t[i].where.line, card.p[i - 1].value, card.p[i].value, card.t[i].value));
}

void act(const Context& context, const deck::PressBc& card) {
  const SelectedSides named = sides_named(context, card.nblok, card.nside);
  if (!has_function(context))
    return;
  const double p1 = card.p1.value, p2 = card.p2.value;
  const Blocks& blocks = context.blocks;
  for (const auto& [b, its] : named.sides) {
    CornerPressures at = {p1, p2};
    if (named.line) {
      const int c = blocks.first_corner[b] + its;
      const auto on_line = [&](int corner) {
        const Vec2 along = named.line->b - named.line->a,
                   from = blocks.corner.col(corner) - named.line->a;
        return p1 + along.dot(from) / along.squaredNorm() * (p2 - p1);
      };
      at = {on_line(c), on_line(blocks.next[c])};
    }
    context.model.loads.pressures.push_back(
        {b, its, at.first, at.second, card.tarriv.value});
  }
  if (named.sides.size() > 1 && !named.line && p1 != p2)
    context.warning(
        card.p2.where,
        fmt::format("p1 and p2 differ, and {} have them at their own corners",
                    counted(named.sides.size(), "side")),
        "along edge(k) or on(x1, y1, x2, y2), the pressure is linear from p1 to p2");
}

void act(const Context& context, const deck::Force& card) {
  const int b = block_named(context, card.nblok);
  if (has_function(context) && b >= 0)
    context.model.loads.forces.push_back(
        {b, {card.fx.value, card.fy.value}, card.tarriv.value});
}

}  // namespace blocks::run
