// REMOVE and FREE: the blocks that the cards name, and what happens to them
// (docs/theory.md#excavation).
#include <fmt/format.h>

#include <algorithm>

#include "deck/points.hpp"
#include "dynamics/preparation/in_situ.hpp"
#include "geometry/polygon.hpp"
#include "geometry/region.hpp"
#include "model/removal.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/names.hpp"
#include "run/builder/selectors.hpp"
#include "run/support/number_ranges.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

/// Corners on slanted lines are rounded, so a block may reach beyond an outline on the
/// same line by this part of its size.
constexpr double rounding_part = 1e-9;

/// Returns the outline, with all corners moved towards the point by that part.
geometry::Polygon shrunk(geometry::Polygon outline, const Vec2& point) {
  for (Vec2& corner : outline)
    corner += rounding_part * (point - corner);
  return outline;
}

bool contains_block(const geometry::Region& region, const Blocks& blocks, int b) {
  const geometry::Polygon outline = blocks.outline(b);
  return region.contains(outline) ||
         region.contains(shrunk(outline, blocks.centroid.col(b)));
}

std::vector<int> select_inside(const Context& context, const deck::Selection& named) {
  // The corners are rounded like those of blocks, so equal decimals meet.
  const geometry::Polygon outline =
      geometry::place_outline(deck::points_of(named.x, named.y), {}, 0);
  const geometry::OutlineCheck check = geometry::check_outline(outline);
  if (check.fault != geometry::OutlineFault::none) {
    const auto at = static_cast<std::size_t>(std::max(check.first, 0));
    context.error(at < named.x.size() ? named.x[at].where : context.command.where,
                  "the outline is not a simple polygon: " + describe(check),
                  "give the corners in order around the outline, in either direction");
    return {};
  }
  const geometry::Region region(outline);
  const Blocks& blocks = context.blocks;
  std::vector<int> chosen;
  std::size_t partly = 0;
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b) || context.state.perhaps_removed.contains(b))
      continue;
    if (named.is_by_centroid() ? region.contains(Vec2(blocks.centroid.col(b)))
                               : contains_block(region, blocks, b))
      chosen.push_back(b);
    else if (region.contains(Vec2(blocks.centroid.col(b))))
      ++partly;
  }
  if (chosen.empty() && context.state.in_place && context.max_missing() == 0)
    context.warning(
        named.nc.where,
        named.is_by_centroid() ? "no centroid of a block is inside the outline"
                               : "no block lies entirely inside the outline",
        partly > 0
            ? fmt::format("{} with the centroid inside {} beyond the outline: "
                          "draw it wider, or give the rule CENTROID",
                          counted(partly, "block"), partly == 1 ? "reaches" : "reach")
            : place_hint(context));
  return chosen;
}

/// Returns the blocks that the card names, removed ones included. Returns nothing after
/// an error, or if there are none, with a warning.
std::vector<int> chosen_by(const Context& context, const deck::Selection& named) {
  if (named.nc.given)
    return select_inside(context, named);
  if (named.nb1.selector)
    return select_blocks(context, named.nb1.where(), *named.nb1.selector);
  return named.mat.given ? find_blocks_of(context, named.mat)
                         : find_blocks(context, named.nb1.number, named.nb2);
}

/// Records what the card did, for the listing and the report of `check`.
void note(const Context& context, const char* done, const std::vector<int>& chosen) {
  std::vector<int>& acted_on = context.state.chosen = chosen;
  std::sort(acted_on.begin(), acted_on.end());
  context.note(fmt::format("{} {}: {}", counted(chosen.size(), "block"), done,
                           number_ranges(chosen)));
}

}  // namespace

void act(const Context& context, const deck::Remove& card) {
  const deck::Selection& named = card.blocks;
  std::vector<int> chosen = chosen_by(context, named);
  if (chosen.empty())
    return;
  std::erase_if(chosen, [&](int b) { return context.blocks.is_removed(b); });
  if (chosen.empty()) {
    context.warning("the blocks named here are removed already");
    return;
  }
  const auto& selector = named.nb1.selector;
  const bool by_position = named.nc.given || (selector && selector->is_by_position());
  if (by_position && !context.state.in_place)
    context.state.perhaps_removed.insert(chosen.begin(), chosen.end());
  else
    remove_blocks(context.model, chosen);
  note(context, "removed", chosen);
}

void act(const Context& context, const deck::Free& card) {
  const std::vector<int> chosen = chosen_by(context, card.blocks);
  if (chosen.empty())
    return;
  const auto chosen_with = [&](Fixity fixity) {
    std::vector<int> found;
    for (const int b : chosen)
      if (context.blocks.fixity[b] == fixity)
        found.push_back(b);
    return found;
  };
  std::vector<int> fixed = chosen_with(Fixity::by_user);
  const std::vector<int> driven = chosen_with(Fixity::driven);
  fixed.insert(fixed.end(), driven.begin(), driven.end());
  if (!fixed.empty()) {
    dynamics::free_in_ground(context.model, fixed);
    note(context, "freed", fixed);
    return;
  }
  const std::vector<int> left = chosen_with(Fixity::left_domain),
                         removed = chosen_with(Fixity::removed);
  if (!left.empty())
    context.warning(blocks_are(context, left) +
                        " outside the domain and cannot be freed",
                    "FREE frees the blocks that FIX or ifix has fixed");
  else if (!removed.empty())
    context.warning(blocks_are(context, removed) + " removed and cannot be freed",
                    "FREE frees the blocks that FIX or ifix has fixed");
  // If not in place, they may have left the domain when FREE acts.
  else if (context.state.in_place)
    context.warning("the blocks named here are free already");
}

}  // namespace blocks::run
