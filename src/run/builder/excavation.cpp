// REMOVE and FREE: the blocks that the cards name, and what happens to them
// (docs/theory.md#excavation).
#include "run/builder/builder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dynamics/preparation/in_situ.hpp"
#include "geometry/polygon.hpp"
#include "geometry/region.hpp"
#include "model/removal.hpp"
#include "run/support/number_ranges.hpp"
#include "text/counted.hpp"

namespace blocks::run {

using deck::Command;

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

}  // namespace

void Builder::remove(const Command& command, const deck::Selection& named) {
  std::vector<int> chosen = chosen_by(command, named);
  if (chosen.empty())
    return;
  std::erase_if(chosen, [&](int b) { return model_.blocks.is_removed(b); });
  if (chosen.empty()) {
    diagnostics_.warning(command.where, command.name,
                         "the blocks named here are removed already");
    return;
  }
  const auto& selector = named.nb1.selector;
  const bool by_position = named.nc.given || (selector && selector->is_by_position());
  if (by_position && !in_place_)
    perhaps_removed_.insert(chosen.begin(), chosen.end());
  else
    remove_blocks(model_, chosen);
  note(command, "removed", chosen);
}

void Builder::free(const Command& command, const deck::Selection& named) {
  std::vector<int> chosen = chosen_by(command, named);
  if (chosen.empty())
    return;
  const auto chosen_with = [&](Fixity fixity) {
    std::vector<int> found;
    for (const int b : chosen)
      if (model_.blocks.fixity[b] == fixity)
        found.push_back(b);
    return found;
  };
  std::vector<int> fixed = chosen_with(Fixity::by_user);
  const std::vector<int> driven = chosen_with(Fixity::driven);
  fixed.insert(fixed.end(), driven.begin(), driven.end());
  if (!fixed.empty()) {
    dynamics::free_in_ground(model_, fixed);
    note(command, "freed", fixed);
    return;
  }
  const std::vector<int> left = chosen_with(Fixity::left_domain),
                         removed = chosen_with(Fixity::removed);
  if (!left.empty())
    diagnostics_.warning(command.where, command.name,
                         blocks_are(left) + " outside the domain and cannot be freed",
                         "FREE frees the blocks that FIX or ifix has fixed");
  else if (!removed.empty())
    diagnostics_.warning(command.where, command.name,
                         blocks_are(removed) + " removed and cannot be freed",
                         "FREE frees the blocks that FIX or ifix has fixed");
  else if (in_place_)  // Otherwise they may have left the domain when FREE acts.
    diagnostics_.warning(command.where, command.name,
                         "the blocks named here are free already");
}

std::vector<int> Builder::chosen_by(const Command& command,
                                    const deck::Selection& named) {
  if (named.nc.given)
    return select_inside(command, named);
  if (named.nb1.selector)
    return select(command, named.nb1.where(), *named.nb1.selector);
  return named.mat.given ? blocks_of_material(command, named.mat)
                         : blocks_in_range(command, named.nb1.number, named.nb2);
}

std::vector<int> Builder::select_inside(const Command& command,
                                        const deck::Selection& named) {
  std::vector<geometry::DecimalPoint> corners;
  for (std::size_t i = 0; i < named.x.size(); ++i)
    corners.push_back({named.x[i].value, named.y[i].value});
  // The corners are rounded like those of blocks, so equal decimals meet.
  const geometry::Polygon outline = geometry::place_outline(corners, {}, 0);
  const geometry::OutlineCheck check = geometry::check_outline(outline);
  if (check.fault != geometry::OutlineFault::none) {
    const auto at = static_cast<std::size_t>(std::max(check.first, 0));
    diagnostics_.error(
        at < named.x.size() ? named.x[at].where : command.where, command.name,
        "the outline is not a simple polygon: " + describe(check),
        "give the corners in order around the outline, in either direction");
    return {};
  }
  const geometry::Region region(outline);
  const Blocks& blocks = model_.blocks;
  std::vector<int> chosen;
  std::size_t partly = 0;
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b) || perhaps_removed_.contains(b))
      continue;
    if (named.is_by_centroid() ? region.contains(Vec2(blocks.centroid.col(b)))
                               : contains_block(region, blocks, b))
      chosen.push_back(b);
    else if (region.contains(Vec2(blocks.centroid.col(b))))
      ++partly;
  }
  if (chosen.empty() && in_place_ && max_missing(command.where.line) == 0)
    diagnostics_.warning(
        named.nc.where, command.name,
        named.is_by_centroid() ? "no centroid of a block is inside the outline"
                               : "no block lies entirely inside the outline",
        partly > 0
            ? fmt::format("{} with the centroid inside {} beyond the outline: "
                          "draw it wider, or give the rule CENTROID",
                          counted(partly, "block"), partly == 1 ? "reaches" : "reach")
            : place_hint(command));
  return chosen;
}

void Builder::note(const Command& command, const char* done,
                   const std::vector<int>& chosen) {
  chosen_ = chosen;
  std::sort(chosen_.begin(), chosen_.end());
  notes_.push_back(fmt::format(
      "{} in line {}{}: {} {}: {}", command.name, command.where.line, time_of_note(),
      counted(chosen.size(), "block"), done, number_ranges(chosen)));
}

}  // namespace blocks::run
