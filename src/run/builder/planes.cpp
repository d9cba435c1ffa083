// The card SPLANE.
#include <fmt/format.h>

#include <algorithm>

#include "dynamics/preparation/in_situ_planes.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/checks.hpp"
#include "run/plausibility/plane_check.hpp"

namespace blocks::run {
namespace {

Plane plane_of(const deck::Splane& card) {
  return {{card.x1.value, card.y1.value}, {card.x2.value, card.y2.value}};
}

}  // namespace

void act(const Context& context, const deck::Splane& card) {
  Model& model = context.model;
  const Plane plane = plane_of(card);
  context.settings.planes.push_back(plane);
  model.search.invalidate();
  context.state.places.planes[context.settings.planes.size() - 1] =
      context.command.where;
  context.state.planes.push_back(context.command);
  const bool after_in_situ = context.settings.in_situ || !model.fixed_in_ground.empty();
  if (after_in_situ && !context.state.unread.has("INSITU") &&
      dynamics::has_sides_on(model, plane))
    context.warning("INSITU has not loaded the sides on this plane",
                    "put SPLANE before INSITU");
}

void check_planes(const Context& context) {
  for (const deck::Command& command : std::exchange(context.state.planes, {})) {
    const auto [a, b] = plane_of(std::get<deck::Splane>(command.card));
    const double rounding =
        0x1p-52 * std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
    const Context card = context.of(command);
    if (rounding > 1e-3 * context.settings.contact_tolerance)
      card.error(fmt::format(
                     "the points are too far away: overlaps would be rounded to {:.2g}",
                     rounding),
                 "give two points of the plane near the blocks");
    if (are_all_behind(context.blocks, {a, b}))
      card.error(
          "all blocks are on the wrong side of the plane",
          "blocks must be on the left when looking from point 1 to point 2: swap "
          "the points");
  }
}

}  // namespace blocks::run
