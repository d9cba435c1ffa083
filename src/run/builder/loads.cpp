// The cards PRESSBC and FORCE, and what cards that name a side or a block to be moved
// have in common.
#include <fmt/format.h>

#include "dynamics/domain.hpp"
#include "run/builder/builder.hpp"
#include "text/counted.hpp"

namespace blocks::run {

using deck::Command;

namespace {

/// [F/L^2] at the two corners of a side.
struct CornerPressures {
  double first, second;
};

}  // namespace

bool Builder::has_function(const Command& command) {
  if (model_.loads.function.empty() && !unread_.has("FUNCTION") &&
      !unread_.has("RESTART"))
    diagnostics_.error(
        command.where, command.name,
        "no FUNCTION card was given, so the load has no time history",
        "add FUNCTION, ntimep among the preliminary cards, followed by ntimep "
        "lines t, p");
  return !model_.loads.function.empty();
}

int Builder::side(const Command& command, int b, const deck::Int& number) {
  const int sides = model_.blocks.corners_of(b);
  if (number.value >= 1 && number.value <= sides)
    return static_cast<int>(number.value) - 1;
  diagnostics_.error(
      number.where, command.name, fmt::format("there is no side {}", number.value),
      fmt::format("block {} has sides 1 to {}", missing_.number_of(b), sides));
  return -1;
}

bool Builder::can_move(const Command& command, int b, deck::SourceLocation where) {
  const Settings& settings = model_.settings;
  if (model_.blocks.fixity[b] == Fixity::left_domain) {
    diagnostics_.warning(where, command.name,
                         fmt::format("block {} is outside the domain and stays there",
                                     missing_.number_of(b)),
                         "widen the domain: XLIMITS, YLIMITS");
    return false;
  }
  const bool has_domain = (settings.lower.array() < settings.upper.array()).all();
  if (!has_domain || dynamics::is_inside_domain(model_.blocks, b, settings))
    return true;
  diagnostics_.error(
      where, command.name,
      fmt::format("block {} has a corner outside the domain, where no block moves",
                  missing_.number_of(b)),
      "widen the domain: XLIMITS, YLIMITS");
  return false;
}

void Builder::press(const Command& command, const deck::PressBc& card) {
  const SelectedSides named = sides_named(command, card.nblok, card.nside);
  if (!has_function(command))
    return;
  const double p1 = card.p1.value, p2 = card.p2.value;
  const Blocks& blocks = model_.blocks;
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
    model_.loads.pressures.push_back({b, its, at.first, at.second, card.tarriv.value});
  }
  if (named.sides.size() > 1 && !named.line && p1 != p2)
    diagnostics_.warning(
        card.p2.where, command.name,
        fmt::format("p1 and p2 differ, and {} have them at their own corners",
                    counted(named.sides.size(), "side")),
        "along edge(k) or on(x1, y1, x2, y2), the pressure is linear from p1 to p2");
}

void Builder::push(const Command& command, const deck::Force& card) {
  const int b = block_named(command, card.nblok);
  if (has_function(command) && b >= 0)
    model_.loads.forces.push_back(
        {b, {card.fx.value, card.fy.value}, card.tarriv.value});
}

}  // namespace blocks::run
