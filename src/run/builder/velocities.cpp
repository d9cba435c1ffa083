// FIX, SETVEL, SETVELM, DRIVE and SERVO: blocks whose velocity is given.
#include <fmt/format.h>

#include "model/drives.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/names.hpp"
#include "run/builder/selectors.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

void set_velocity(const Context& context, std::vector<int> chosen,
                  deck::SourceLocation where, const auto& card) {
  leave_out_removed(context, where, chosen);
  Blocks& blocks = context.blocks;
  for (const int b : chosen) {
    if (!blocks.is_free(b))
      continue;
    blocks.velocity.col(b) = Vec2(card.vx.value, card.vy.value);
    blocks.spin[b] = card.tdot.value;
  }
}

/// Returns whether DRIVE or SERVO can act on the block: it is fixed and inside the
/// domain. Otherwise reports an error or a warning.
bool can_drive(const Context& context, int b, const deck::NumberOrSelector& named) {
  if (!context.blocks.is_free(b))
    return can_move(context, b, named.where());
  // A FIX card with a fault may have named the block, and a selector may name others
  // when the run gets here.
  const BuilderState& state = context.state;
  const bool is_certain =
      state.in_place ||
      (!state.perhaps_fixed && !(named.selector && named.selector->is_by_position()));
  const long number = state.numbers.number_of(b);
  if (!state.unread.has("FIX") && is_certain)
    context.error(named.where(), fmt::format("block {} is not fixed", number),
                  fmt::format("only fixed blocks can be driven: put FIX, {} before "
                              "this card, or use {} for a free block",
                              number,
                              context.command.name == "SERVO" ? "PRESSBC" : "SETVEL"));
  return false;
}

}  // namespace

void act(const Context& context, const deck::Fix& card) {
  for (const int b : blocks_named(context, card.nblok)) {
    context.blocks.fix(b, Fixity::by_user);
    end_drive(context.model, b);
    context.model.search.invalidate();
  }
  context.state.perhaps_fixed |= card.nblok.selector && !context.state.in_place;
}

void act(const Context& context, const deck::SetVel& card) {
  set_velocity(context,
               card.nb1.selector ? blocks_named(context, card.nb1)
                                 : find_blocks(context, card.nb1.number, card.nb2),
               card.nb1.where(), card);
}

void act(const Context& context, const deck::SetVelM& card) {
  set_velocity(context, find_blocks_of(context, card.mat), card.mat.where, card);
}

void act(const Context& context, const deck::Drive& card) {
  const std::vector<int> chosen = blocks_named(context, card.nb);
  if (chosen.size() > 1 && card.tdot.value != 0.0) {
    error_several(context, card.nb, counted(chosen.size(), "block"));
    return;
  }
  for (const int b : chosen)
    if (can_drive(context, b, card.nb))
      drive_block(context.model, {b, {card.vx.value, card.vy.value}, card.tdot.value});
}

void act(const Context& context, const deck::Servo& card) {
  const std::vector<BlockSide> sides = sides_named(context, card.nb, card.nside).sides;
  if (sides.size() > 1)
    error_several(context, card.nside.selector ? card.nside : card.nb,
                  counted(sides.size(), "side"));
  if (sides.size() != 1)
    return;
  const auto [b, its] = sides.front();
  if (can_drive(context, b, card.nb.given() ? card.nb : card.nside))
    start_servo(context.model, {b, its, card.s.value, card.vmax.value});
}

}  // namespace blocks::run
