// The card QUIET (docs/waves.md).
#include <fmt/format.h>

#include <cmath>

#include "dynamics/preparation/quiet.hpp"
#include "dynamics/preparation/time_step.hpp"
#include "model/equilibrium.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/names.hpp"
#include "run/builder/selectors.hpp"

namespace blocks::run {
namespace {

/// Puts the wave speeds of the card or of the block's material into `quiet`. Returns
/// false if they cannot be known.
bool find_speeds(const Context& context, const deck::Quiet& card, QuietSide& quiet) {
  const bool rigid = context.settings.rigid || context.state.unread.has("RIGID");
  if (rigid && !card.cp.given) {
    context.error("rigid blocks need cp",
                  "waves pass rigid blocks through the springs of their contacts, "
                  "so give the speed in the whole model");
    return false;
  }
  quiet.cp = card.cp.value, quiet.cs = card.cs.given ? card.cs.value : 0.5 * quiet.cp;
  if (!rigid) {
    const Material& material =
        context.settings.materials.at(context.blocks.material[quiet.block]);
    if (!card.cp.given)
      quiet.cp = std::sqrt(material.c11() / material.density);
    if (!card.cs.given)
      quiet.cs = std::sqrt(material.shear_modulus / material.density);
    if (!(quiet.cp > 0.0) || !(quiet.cs > 0.0) || !std::isfinite(quiet.cp))
      return false;  // END has reported the elastic constants.
  }
  if (card.cs.given && quiet.cs > quiet.cp)
    context.warning(
        card.cs.where,
        fmt::format("cs = {:g} is greater than cp = {:.6g}", quiet.cs, quiet.cp),
        "shear waves are slower than compression waves in every elastic solid");
  return true;
}

/// Warns if the dashpots of the block's quiet sides are too strong for the time step.
void warn_of_dashpots(const Context& context, int b) {
  // The dashpots take rate * dt of the velocity in a step. If that is more than all of
  // it, the velocity is reversed. Deformable squares reach 1 if their own stiffness
  // sets the time step, and must not be warned of by rounding.
  constexpr double max = 1.01;
  const double dt = context.model.time_step.blocks == context.blocks.size()
                        ? context.model.time_step.dt
                        : dynamics::choose_time_step(context.model).dt;
  const double rate = dynamics::decay_rate(context.blocks, context.settings.rigid, b,
                                           context.model.loads.quiet_sides);
  if (rate * dt <= max)
    return;
  context.warning(
      fmt::format("the dashpots of block {} would take {:.3g} times its velocity in a "
                  "time step of {:.4g}",
                  context.state.numbers.number_of(b), rate * dt, dt),
      fmt::format("steps beyond {:.3g} may be unstable: reduce FRACTION, or cp and cs",
                  1.0 / rate));
}

void make_quiet(const Context& context, const deck::Quiet& card,
                const BlockSide& side) {
  const auto [b, its] = side;
  const Blocks& blocks = context.blocks;
  const Settings& settings = context.settings;
  if (!can_move(context, b, (card.nb.given() ? card.nb : card.nside).where()))
    return;
  QuietSide quiet{.block = b, .side = its};
  if (!find_speeds(context, card, quiet))
    return;
  const long number = context.state.numbers.number_of(b);
  const bool was_free = blocks.is_free(b);
  if (!was_free && !context.has_moved() && !settings.in_situ &&
      settings.gravity_at(context.model.time).norm() > 0.0)
    context.warning(
        fmt::format("block {} is freed before the first step, so only its own weight "
                    "is held",
                    number),
        "bring the model to rest on the fixed block first: SOLVE or MOTION");
  const bool moves =
      !was_free && (!blocks.velocity.col(b).isZero(0.0) || blocks.spin[b] != 0.0);
  if (moves || (!was_free && loads_will_change(context.model)))
    context.warning(
        fmt::format("block {} is freed while {}", number,
                    moves ? "it moves" : "gravity or a load still changes"),
        "the force that holds it from now on is that of this moment: bring the model "
        "to rest first");
  const Vec2 held = dynamics::make_quiet(context.model, quiet);
  warn_of_dashpots(context, b);
  if (!context.state.in_place)  // The time and the reaction are those of the run.
    return;
  std::string text = fmt::format("side {} of block {}, cp {:g}, cs {:g}",
                                 quiet.side + 1, number, quiet.cp, quiet.cs);
  if (!was_free)
    text += fmt::format("; the block is freed and held by the constant force ({:g}, "
                        "{:g})",
                        held.x(), held.y());
  context.note(text);
}

}  // namespace

void act(const Context& context, const deck::Quiet& card) {
  for (const BlockSide& side : sides_named(context, card.nb, card.nside).sides)
    make_quiet(context, card, side);
}

}  // namespace blocks::run
