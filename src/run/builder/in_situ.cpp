// The card INSITU (docs/rest.md).
#include <fmt/format.h>

#include <cmath>

#include "dynamics/preparation/in_situ.hpp"
#include "model/equilibrium.hpp"
#include "run/builder/cards.hpp"
#include "text/counted.hpp"

namespace blocks::run {

void act(const Context& context, const deck::Insitu& card) {
  context.state.balanced = true;
  if (!context.state.in_place)
    return;
  const dynamics::InSituReport report = dynamics::load_faces(
      context.model, {card.sxx.value, card.syy.value, card.sxy.value, card.dxx.value,
                      card.dyy.value, card.dxy.value});
  const double ratio = unbalanced_ratio(context.model);
  context.note(fmt::format("{} loaded, unbalanced force ratio {:.2g}",
                           counted(report.faces, "face"), ratio));
  if (context.diagnostics.has_errors())
    return;
  if (report.faces == 0)
    context.warning(
        fmt::format("no faces are flush within {:g}, so nothing is loaded",
                    dynamics::flush_tolerance(context.settings)),
        "put INSITU after the cards that make blocks; it loads faces whose gap or "
        "overlap is at most a hundredth of ctol, those of two fixed blocks when FREE "
        "releases one");
  constexpr double balanced = 1e-3;
  if (ratio > balanced && report.faces > 0 && report.open == 0)
    context.warning(
        fmt::format("the stress is not in equilibrium: unbalanced force ratio {:.2g}",
                    ratio),
        "dyy is the density times the size of gravity, dxy is 0, and fixed blocks or "
        "PRESSBC must carry the stress at all outer sides");
  if (report.open > 0)
    context.warning(
        fmt::format("{} without tensile strength would be in tension: no force there",
                    counted(report.open, "contact")),
        "the blocks move until the forces balance; BOND gives joints strength");
  if (report.sheared > 0)
    context.warning(
        fmt::format("{} on symmetry planes would bear shear: no shear force there",
                    counted(report.sheared, "corner")),
        "a symmetry plane must be a principal plane of the stress");
  if (report.weak > 0)
    context.warning(
        fmt::format("{} cannot carry the stress and will slip or fail; the worst is "
                    "at ({:g}, {:g}) with a shear force of {:g} and a normal force "
                    "of {:g}",
                    counted(report.weak, "contact"), report.weakest.x(),
                    report.weakest.y(), std::abs(report.shear), report.normal),
        "raise the friction, or lower sxy or the difference of sxx and syy");
}

}  // namespace blocks::run
