// The cards PRESSBC and FORCE, and what cards that name a side or a block to be moved
// have in common.
#include <fmt/format.h>

#include "dynamics/domain.hpp"
#include "run/builder.hpp"

namespace blocks::run {

using deck::Command;

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

bool Builder::can_move(const Command& command, int b, const deck::Int& number) {
  const Settings& settings = model_.settings;
  if (model_.blocks.fixity[b] == Fixity::left_domain) {
    diagnostics_.warning(number.where, command.name,
                         fmt::format("block {} is outside the domain and stays there",
                                     missing_.number_of(b)),
                         "widen the domain: XLIMITS, YLIMITS");
    return false;
  }
  const bool has_domain = (settings.lower.array() < settings.upper.array()).all();
  if (!has_domain || dynamics::is_inside_domain(model_.blocks, b, settings))
    return true;
  diagnostics_.error(
      number.where, command.name,
      fmt::format("block {} has a corner outside the domain, where no block moves",
                  missing_.number_of(b)),
      "widen the domain: XLIMITS, YLIMITS");
  return false;
}

void Builder::press(const Command& command, const deck::PressBc& card) {
  const int b = block_to_change(command, card.nblok);
  if (!has_function(command) || b < 0)
    return;
  if (const int its = side(command, b, card.nside); its >= 0)
    model_.loads.pressures.push_back(
        {b, its, card.p1.value, card.p2.value, card.tarriv.value});
}

void Builder::push(const Command& command, const deck::Force& card) {
  const int b = block_to_change(command, card.nblok);
  if (has_function(command) && b >= 0)
    model_.loads.forces.push_back(
        {b, {card.fx.value, card.fy.value}, card.tarriv.value});
}

}  // namespace blocks::run
