// The card QUIET (docs/waves.md).
#include "run/builder/builder.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dynamics/preparation/make_quiet.hpp"
#include "dynamics/preparation/time_step.hpp"
#include "model/equilibrium.hpp"

namespace blocks::run {

using deck::Command;

bool Builder::find_speeds(const Command& command, const deck::Quiet& card,
                          QuietSide& quiet) {
  const bool rigid = model_.settings.rigid || unread_.has("RIGID");
  if (rigid && !card.cp.given) {
    diagnostics_.error(command.where, command.name, "rigid blocks need cp",
                       "waves pass rigid blocks through the springs of their contacts, "
                       "so give the speed in the whole model");
    return false;
  }
  quiet.cp = card.cp.value, quiet.cs = card.cs.given ? card.cs.value : 0.5 * quiet.cp;
  if (!rigid) {
    const Material& material =
        model_.settings.materials.at(model_.blocks.material[quiet.block]);
    if (!card.cp.given)
      quiet.cp = std::sqrt(material.c11() / material.density);
    if (!card.cs.given)
      quiet.cs = std::sqrt(material.shear_modulus / material.density);
    if (!(quiet.cp > 0.0) || !(quiet.cs > 0.0) || !std::isfinite(quiet.cp))
      return false;  // END has reported the elastic constants.
  }
  if (card.cs.given && quiet.cs > quiet.cp)
    diagnostics_.warning(
        card.cs.where, command.name,
        fmt::format("cs = {:g} is greater than cp = {:.6g}", quiet.cs, quiet.cp),
        "shear waves are slower than compression waves in every elastic solid");
  return true;
}

void Builder::make_quiet(const Command& command, const deck::Quiet& card) {
  for (const BlockSide& side : sides_named(command, card.nb, card.nside).sides)
    make_quiet(command, card, side);
}

void Builder::make_quiet(const Command& command, const deck::Quiet& card,
                         const BlockSide& side) {
  const auto [b, its] = side;
  const Blocks& blocks = model_.blocks;
  const Settings& settings = model_.settings;
  if (!can_move(command, b, (card.nb.given() ? card.nb : card.nside).where()))
    return;
  QuietSide quiet{.block = b, .side = its};
  if (!find_speeds(command, card, quiet))
    return;
  const bool was_free = blocks.is_free(b);
  if (!was_free && !has_moved() && !settings.in_situ &&
      settings.gravity_at(model_.time).norm() > 0.0)
    diagnostics_.warning(
        command.where, command.name,
        fmt::format("block {} is freed before the first step, so only its own weight "
                    "is held",
                    missing_.number_of(b)),
        "bring the model to rest on the fixed block first: SOLVE or MOTION");
  const bool moves =
      !was_free && (!blocks.velocity.col(b).isZero(0.0) || blocks.spin[b] != 0.0);
  if (moves || (!was_free && loads_will_change(model_)))
    diagnostics_.warning(
        command.where, command.name,
        fmt::format("block {} is freed while {}", missing_.number_of(b),
                    moves ? "it moves" : "gravity or a load still changes"),
        "the force that holds it from now on is that of this moment: bring the model "
        "to rest first");
  const Vec2 held = dynamics::make_quiet(model_, quiet);
  warn_of_dashpots(command, b);
  if (!in_place_)  // The time and the reaction are those of the run.
    return;
  std::string text = fmt::format(
      "QUIET in line {} at time {:g}: side {} of block {}, cp {:g}, cs {:g}",
      command.where.line, model_.time, quiet.side + 1, missing_.number_of(b), quiet.cp,
      quiet.cs);
  if (!was_free)
    text += fmt::format("; the block is freed and held by the constant force ({:g}, "
                        "{:g})",
                        held.x(), held.y());
  notes_.push_back(std::move(text));
}

void Builder::warn_of_dashpots(const Command& command, int b) {
  // The dashpots take rate * dt of the velocity in a step. If that is more than all of
  // it, the velocity is reversed. Deformable squares reach 1 if their own stiffness
  // sets the time step, and must not be warned of by rounding.
  constexpr double max = 1.01;
  const double dt = model_.time_step.blocks == model_.blocks.size()
                        ? model_.time_step.dt
                        : dynamics::choose_time_step(model_).dt;
  const double rate = dynamics::decay_rate(model_.blocks, model_.settings.rigid, b,
                                           model_.loads.quiet_sides);
  if (rate * dt <= max)
    return;
  diagnostics_.warning(
      command.where, command.name,
      fmt::format("the dashpots of block {} would take {:.3g} times its velocity in a "
                  "time step of {:.4g}",
                  missing_.number_of(b), rate * dt, dt),
      fmt::format("steps beyond {:.3g} may be unstable: reduce FRACTION, or cp and cs",
                  1.0 / rate));
}

}  // namespace blocks::run
