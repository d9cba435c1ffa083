// The cards INSITU and SERVO (docs/rest.md).
#include "run/builder/builder.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dynamics/preparation/in_situ.hpp"
#include "dynamics/preparation/in_situ_planes.hpp"
#include "model/drives.hpp"
#include "model/equilibrium.hpp"
#include "text/counted.hpp"

namespace blocks::run {

using deck::Command;

void Builder::load_in_situ(const Command& command, const deck::Insitu& card) {
  if (!in_place_)
    return;
  const dynamics::InSituReport report =
      dynamics::load_faces(model_, {card.sxx.value, card.syy.value, card.sxy.value,
                                    card.dxx.value, card.dyy.value, card.dxy.value});
  const double ratio = unbalanced_ratio(model_);
  notes_.push_back(fmt::format(
      "INSITU in line {} at time {:g}: {} loaded, unbalanced force ratio "
      "{:.2g}",
      command.where.line, model_.time, counted(report.faces, "face"), ratio));
  if (diagnostics_.has_errors())
    return;
  const auto warn = [&](const std::string& message, const std::string& hint) {
    diagnostics_.warning(command.where, command.name, message, hint);
  };
  if (report.faces == 0)
    warn(fmt::format("no faces are flush within {:g}, so nothing is loaded",
                     dynamics::flush_tolerance(model_.settings)),
         "put INSITU after the cards that make blocks; it loads faces whose gap or "
         "overlap is at most a hundredth of ctol, those of two fixed blocks when FREE "
         "releases one");
  constexpr double balanced = 1e-3;
  if (ratio > balanced && report.faces > 0 && report.open == 0)
    warn(fmt::format("the stress is not in equilibrium: unbalanced force ratio {:.2g}",
                     ratio),
         "dyy is the density times the size of gravity, dxy is 0, and fixed blocks or "
         "PRESSBC must carry the stress at all outer sides");
  if (report.open > 0)
    warn(fmt::format("{} without tensile strength would be in tension: no force there",
                     counted(report.open, "contact")),
         "the blocks move until the forces balance; BOND gives joints strength");
  if (report.sheared > 0)
    warn(fmt::format("{} on symmetry planes would bear shear: no shear force there",
                     counted(report.sheared, "corner")),
         "a symmetry plane must be a principal plane of the stress");
  if (report.weak > 0)
    warn(fmt::format("{} cannot carry the stress and will slip or fail; the worst is "
                     "at ({:g}, {:g}) with a shear force of {:g} and a normal force "
                     "of {:g}",
                     counted(report.weak, "contact"), report.weakest.x(),
                     report.weakest.y(), std::abs(report.shear), report.normal),
         "raise the friction, or lower sxy or the difference of sxx and syy");
}

void Builder::check_plane_in_ground(const Command& command, const Plane& plane) {
  const bool after_in_situ = model_.settings.in_situ || !model_.fixed_in_ground.empty();
  if (after_in_situ && !unread_.has("INSITU") && dynamics::has_sides_on(model_, plane))
    diagnostics_.warning(command.where, command.name,
                         "INSITU has not loaded the sides on this plane",
                         "put SPLANE before INSITU");
}

void Builder::check_equilibrium(const Command& fos) {
  if (balanced_ || model_.settings.in_situ || !model_.solves.empty() ||
      unread_.has("SOLVE") || unread_.has("INSITU") || unread_.has("RESTART"))
    return;
  diagnostics_.error(fos.where, fos.name,
                     "no SOLVE or INSITU before it has balanced the forces",
                     "put SOLVE before it; trials start from a state of equilibrium");
}

void Builder::servo(const Command& command, const deck::Servo& card) {
  const SelectedSides named = sides_named(command, card.nb, card.nside);
  if (named.sides.empty())
    return;
  if (named.sides.size() > 1) {
    error_several(command, card.nside.selector ? card.nside : card.nb,
                  counted(named.sides.size(), "side"));
    return;
  }
  const auto [b, its] = named.sides.front();
  if (can_drive(command, b, card.nb.given() ? card.nb : card.nside))
    start_servo(model_, {b, its, card.s.value, card.vmax.value});
}

}  // namespace blocks::run
