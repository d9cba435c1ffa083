// The cards INSITU and SERVO (docs/rest.md).
#include "run/builder.hpp"

#include <fmt/format.h>

#include "model/drives.hpp"

namespace blocks::run {

using deck::Command;

void Builder::load_in_situ(const Command&, const deck::Insitu&) {}

void Builder::servo(const Command& command, const deck::Servo& card) {
  const int b = block_to_drive(command, card.nb);
  if (b < 0 || most_missing(command.where.line) > 0)
    return;
  const int sides = model_.blocks.corners_of(b);
  if (card.nside.value > sides) {
    diagnostics_.error(card.nside.where, command.name,
                       fmt::format("there is no side {}", card.nside.value),
                       fmt::format("block {} has sides 1 to {}", b + 1, sides));
    return;
  }
  start_servo(model_, {b, static_cast<int>(card.nside.value) - 1, card.s.value,
                       card.vmax.value});
}

}  // namespace blocks::run
