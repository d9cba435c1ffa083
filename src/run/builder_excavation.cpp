// REMOVE and FREE: the blocks that the cards name, and what happens to them
// (docs/theory.md#excavation).
#include "run/builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "geometry/polygon.hpp"
#include "geometry/region.hpp"
#include "model/removal.hpp"
#include "run/number_ranges.hpp"

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

std::string counted(std::size_t count) {
  return fmt::format("{} block{}", count, count == 1 ? "" : "s");
}

/// Returns the hint of a warning that there is no such block.
std::string place_hint(const Command& command) {
  return command.name + " takes effect at its place in the deck: put it after the "
                        "cards that make the blocks";
}

}  // namespace

void Builder::remove(const Command& command, const deck::Selection& named) {
  std::vector<int> chosen = select(command, named);
  if (chosen.empty())
    return;
  std::erase_if(chosen, [&](int b) { return model_.blocks.is_removed(b); });
  if (chosen.empty()) {
    diagnostics_.warning(command.where, command.name,
                         "the blocks named here are removed already");
    return;
  }
  if (!is_in_place())
    for (const int b : chosen)
      removed_later_.emplace_back(b, model_.blocks.fixity[b]);
  remove_blocks(model_, chosen);
  note(command, "removed", chosen);
}

void Builder::put_back_removed() {
  if (certificate_ && certificate_->blocks == model_.blocks.size())
    for (const auto& [b, fixity] : removed_later_)
      model_.blocks.fixity[b] = fixity;
  removed_later_.clear();
}

void Builder::free(const Command& command, const deck::Selection& named) {
  std::vector<int> chosen = select(command, named);
  if (chosen.empty())
    return;
  const Blocks& blocks = model_.blocks;
  const auto count = [&](Fixity fixity) {
    return std::count_if(chosen.begin(), chosen.end(),
                         [&](int b) { return blocks.fixity[b] == fixity; });
  };
  const auto left = count(Fixity::left_domain), removed = count(Fixity::removed);
  std::erase_if(chosen, [&](int b) { return blocks.fixity[b] != Fixity::by_user; });
  if (chosen.empty()) {
    // Before the motions the check does not know which blocks will leave the domain.
    if (left > 0 || removed > 0 || is_in_place())
      diagnostics_.warning(command.where, command.name,
                           left > 0      ? "a block that left the domain remains fixed"
                           : removed > 0 ? "a removed block remains removed"
                                         : "the blocks named here are free already");
    return;
  }
  free_blocks(model_, chosen);
  freed_ = true;
  note(command, "freed", chosen);
}

std::vector<int> Builder::select(const Command& command, const deck::Selection& named) {
  if (named.nc.given)
    return select_inside(command, named);
  const Blocks& blocks = model_.blocks;
  std::vector<int> chosen;
  if (named.mat.given) {
    if (!has_material(command, named.mat))
      return {};
    for (int b = 0; b < blocks.size(); ++b)
      if (blocks.material[b] == named.mat.value)
        chosen.push_back(b);
    if (chosen.empty() && most_missing(command.where.line) == 0)
      diagnostics_.warning(
          named.mat.where, command.name,
          fmt::format("no block of material {} exists here", named.mat.value),
          place_hint(command));
    return chosen;
  }
  const int first = block(command, named.nb1);
  const int last = first < 0 ? -1 : last_block(command, first, named.nb2);
  if (last < 0)
    return {};
  chosen.resize(static_cast<std::size_t>(last - first + 1));
  std::iota(chosen.begin(), chosen.end(), first);
  return chosen;
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
    if (blocks.is_removed(b))
      continue;
    if (contains_block(region, blocks, b))
      chosen.push_back(b);
    else if (region.contains(Vec2(blocks.centroid.col(b))))
      ++partly;
  }
  if (chosen.empty() && is_in_place() && most_missing(command.where.line) == 0)
    diagnostics_.warning(
        named.nc.where, command.name, "no block lies entirely inside the outline",
        partly > 0 ? fmt::format("{} with the centroid inside {} beyond the outline: "
                                 "draw it wider",
                                 counted(partly), partly == 1 ? "reaches" : "reach")
                   : place_hint(command));
  return chosen;
}

void Builder::note(const Command& command, const char* done,
                   const std::vector<int>& chosen) {
  notes_.push_back(fmt::format("{} in line {}{}: {} {}: {}", command.name,
                               command.where.line,
                               is_in_place() ? fmt::format(" at time {:g}", model_.time)
                                             : std::string(", if nothing moves before"),
                               counted(chosen.size()), done, number_ranges(chosen)));
}

}  // namespace blocks::run
