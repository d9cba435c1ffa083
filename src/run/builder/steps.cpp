// MOTION, CYCLE, SOLVE and FOS: what cards after them must know. Another folder makes
// the steps.
#include <fmt/format.h>

#include "dynamics/preparation/time_step.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/checks.hpp"

namespace blocks::run {
namespace {

void pass_time(const Context& context) {
  BuilderState& state = context.state;
  ++state.section;
  state.in_place = state.moves;
  if (!state.in_place && !context.settings.crack_rules.empty())
    state.numbers.may_split(context.blocks.size());
}

/// Reports a FOS card before which no SOLVE or INSITU has balanced the forces.
void check_equilibrium(const Context& fos) {
  const UnreadCards& unread = fos.state.unread;
  if (fos.state.balanced || fos.settings.in_situ || !fos.model.solves.empty() ||
      unread.has("SOLVE") || unread.has("INSITU") || unread.has("RESTART"))
    return;
  fos.error("no SOLVE or INSITU before it has balanced the forces",
            "put SOLVE before it; trials start from a state of equilibrium");
}

}  // namespace

void act(const Context& context, const deck::Motion&) { pass_time(context); }

void act(const Context& context, const deck::Cycle&) { pass_time(context); }

void act(const Context& context, const deck::Solve&) {
  context.state.balanced = true;
  check_damping(context);
  pass_time(context);
}

void act(const Context& context, const deck::Fos&) {
  check_damping(context);
  check_equilibrium(context);
  pass_time(context);
}

void check_steps(const Context& motion) {
  const auto* card = std::get_if<deck::Motion>(&motion.command.card);
  if (card == nullptr)
    return;
  constexpr double max = 1e15;
  const double dt = dynamics::choose_time_step(motion.model).dt;
  if (!(card->dt.value / dt <= max))
    motion.error(card->dt.where,
                 fmt::format("{:g} would take more than {:g} steps of {:g}",
                             card->dt.value, max, dt),
                 "give a shorter time");
  else if (card->dt.value <= 1e-9 * dt)
    motion.warning(
        card->dt.where,
        fmt::format("{:g} is too short for a time step of {:.4g}", card->dt.value, dt),
        "no time passes; CYCLE, 1 makes one step");
}

}  // namespace blocks::run
