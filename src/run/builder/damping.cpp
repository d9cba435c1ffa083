// FRACTION, DAMPING, LOCDAMP, KINDAMP, MDAMP and MSCALE: damping and the time step
// (docs/rest.md).
#include <fmt/format.h>

#include <algorithm>

#include "model/equilibrium.hpp"
#include "model/safe_fraction.hpp"
#include "model/words/time_step_text.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/checks.hpp"
#include "run/builder/names.hpp"

namespace blocks::run {
namespace {

/// The damping has changed, and the time step may depend on it.
void choose_step_again(const Context& context) {
  context.state.fraction = context.command;
  if (chooses_fraction(context.settings))
    context.model.time_step.blocks = 0;
}

}  // namespace

void act(const Context& context, const deck::Fraction& card) {
  context.settings.fraction = card.tfrac.value;
  context.state.fraction = context.command;
}

void act(const Context& context, const deck::Damping& card) {
  context.settings.damping = card.beta.value;
  choose_step_again(context);
}

void act(const Context& context, const deck::Locdamp& card) {
  context.settings.local_damping = card.alpha.value;
  choose_step_again(context);
}

void act(const Context& context, const deck::Kindamp& card) {
  context.settings.kinetic_damping = card.on.value != 0;
  context.model.last_kinetic_energy = 0.0;
}

void act(const Context& context, const deck::Mdamp& card) {
  if (!has_material(context, card.mat))
    return;
  context.settings.materials.at(static_cast<int>(card.mat.value)).damping =
      card.z.value;
  context.model.time_step.blocks = 0;  // strong damping needs a shorter one
}

void act(const Context& context, const deck::Mscale& card) {
  context.settings.mass_scaling = card.on.value != 0;
}

void check_fraction(const Context& motion) {
  const Settings& settings = motion.settings;
  double& warned = motion.state.warned_fraction;
  const double safe = safe_fraction(settings);
  if (settings.fraction > safe && (warned == 0.0 || safe < warned)) {
    const std::string given = fmt::format("FRACTION {:g} with {}", settings.fraction,
                                          damping_in_words(settings));
    const std::string hint = fmt::format(
        "for 8 contacts per block the largest safe FRACTION is {:.2g}; if it is blank, "
        "the program counts the contacts (docs/theory.md, time step)",
        safe);
    // Without damping, such a step is unstable even for a single contact.
    constexpr double refused = 3.0;
    const auto& fixity = motion.blocks.fixity;
    const bool may_be_packed =
        std::count(fixity.begin(), fixity.end(), Fixity::free) > 1;
    const auto& by = motion.state.fraction;
    const Context to_blame = by ? motion.of(*by) : motion;
    if (settings.fraction > refused * safe && may_be_packed)
      to_blame.error(given + " is unstable: packed blocks would fly apart", hint);
    else
      to_blame.warning(given + " may never let packed blocks come to rest", hint);
  }
  warned = safe;
}

void check_damping(const Context& solve) {
  const Settings& settings = solve.settings;
  if (settings.mass_scaling && !solve.model.loads.quiet_sides.empty())
    solve.warning("MSCALE does not act, because the model has quiet sides",
                  "their dashpots belong to the true masses; put QUIET after SOLVE");
  if (settings.damping > 0.0 || is_damped_to_rest(settings) ||
      solve.state.unread.has("RESTART"))
    return;
  solve.warning("nothing damps the motion, so the blocks may never come to rest",
                "put LOCDAMP, KINDAMP or DAMPING before it (docs/rest.md)");
}

}  // namespace blocks::run
