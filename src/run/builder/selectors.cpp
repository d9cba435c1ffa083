#include "run/builder/selectors.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/polygon.hpp"
#include "run/builder/names.hpp"
#include "run/support/number_ranges.hpp"
#include "text/counted.hpp"

namespace blocks::run {

using By = deck::Selector::By;

namespace {

/// Returns the point whose coordinates begin at this index of the numbers.
Vec2 point_of(const deck::Selector& selector, std::size_t index) {
  return {selector.numbers[index].value(), selector.numbers[index + 1].value()};
}

std::vector<int> blocks_of(const std::vector<BlockSide>& sides) {
  std::vector<int> blocks;
  for (const BlockSide& side : sides)
    if (blocks.empty() || blocks.back() != side.block)
      blocks.push_back(side.block);
  return blocks;
}

bool is_gone(const Context& context, int b) {
  return context.blocks.is_removed(b) || context.state.perhaps_removed.contains(b);
}

std::string nearest_hint(const Context& context, const Vec2& point) {
  const Blocks& blocks = context.blocks;
  const BlockCorner nearest = nearest_corner(blocks, point);
  if (nearest.block < 0)
    return "no block exists here";
  const Vec2 at =
      blocks.corner.col(blocks.first_corner[nearest.block] + nearest.corner);
  return fmt::format("the nearest corner is that of block {} at ({:.6g}, {:.6g})",
                     context.state.numbers.number_of(nearest.block), at.x(), at.y());
}

void error_nothing(const Context& context, deck::SourceLocation where,
                   const deck::Selector& selector, std::string hint) {
  // Blocks may be elsewhere when the run gets here, or missing after an error.
  if ((selector.is_by_position() && !context.state.in_place) ||
      context.diagnostics.has_errors() || context.max_missing() > 0)
    return;
  const char* what = selector.by == By::nearest ? "corner"
                     : selector.is_of_sides()   ? "side"
                                                : "block";
  context.error(where, fmt::format("{} selects no {}", selector.text, what),
                context.blocks.count_present() == 0 ? place_hint(context)
                                                    : std::move(hint));
}

void note_selected(const Context& context, const deck::Selector& selector,
                   const std::vector<int>& chosen) {
  if (!chosen.empty())
    context.note(fmt::format(
        "{} selects {}{}", selector.text,
        chosen.size() == 1 ? "block " : counted(chosen.size(), "block") + ": ",
        number_ranges(chosen)));
}

void note_selected(const Context& context, const deck::Selector& selector,
                   const std::vector<BlockSide>& sides) {
  if (sides.empty())
    return;
  const std::vector<int> blocks = blocks_of(sides);
  context.note(fmt::format("{} selects {} of {} {}", selector.text,
                           sides.size() == 1 ? fmt::format("side {}", sides[0].side + 1)
                                             : counted(sides.size(), "side"),
                           blocks.size() == 1 ? "block" : "blocks",
                           number_ranges(blocks)));
}

/// Returns the sides of a selector, or nothing after an error.
std::optional<SelectedSides> select_sides(const Context& context,
                                          deck::SourceLocation where,
                                          const deck::Selector& selector) {
  const auto beside = [&](const Vec2& a, const Vec2& b, SidesOf which) {
    const double tolerance =
        context.has_moved() ? context.settings.contact_tolerance : 0.0;
    return SelectedSides{sides_on(context.blocks, a, b, which, tolerance), Plane{a, b}};
  };
  if (selector.by == By::joint)
    return SelectedSides{
        sides_of_joint(context.blocks, static_cast<int>(selector.numbers[0].value()))};
  if (selector.by == By::on)
    return beside(point_of(selector, 0), point_of(selector, 2), SidesOf::both);
  const auto k = static_cast<std::size_t>(selector.numbers[0].value());
  const geometry::Polygon& outline = context.state.last_outline;
  const std::size_t edges = outline.size();
  if (edges == 0 &&
      (context.state.unread.has("CUT") || context.state.numbers.some_failed()))
    return std::nullopt;
  if (k > edges) {
    context.error(
        where,
        edges == 0 ? "no OUTLINE above has edges"
                   : fmt::format("the outline has no edge {}", k),
        edges == 0
            ? "on(x1, y1, x2, y2) selects sides on a line"
            : fmt::format("it has edges 1 to {}; edge i runs from corner i to i + 1",
                          edges));
    return std::nullopt;
  }
  const bool anticlockwise = geometry::check_outline(outline).anticlockwise;
  return beside(outline[k - 1], outline[k % edges],
                anticlockwise ? SidesOf::left : SidesOf::right);
}

}  // namespace

std::vector<int> select_blocks(const Context& context, deck::SourceLocation where,
                               const deck::Selector& selector) {
  const Blocks& blocks = context.blocks;
  std::vector<int> chosen;
  std::string hint;
  if (selector.by == By::at) {
    const Vec2 point = point_of(selector, 0);
    if (const int b = block_at(blocks, point); b >= 0)
      chosen = {b};
    hint = nearest_hint(context, point);
  } else if (selector.by == By::in) {
    chosen = blocks_in(blocks, point_of(selector, 0), point_of(selector, 2));
    hint = "it selects blocks whose centroid is in the box between the two points";
  } else {
    const int material = find_material(context, where, selector.material);
    if (material == 0)
      return {};
    chosen = blocks_of_material(blocks, material);
    hint = fmt::format("no block of material {} exists here", material);
  }
  std::erase_if(chosen, [&](int b) { return is_gone(context, b); });
  if (chosen.empty())
    error_nothing(context, where, selector, std::move(hint));
  return chosen;
}

std::optional<BlockCorner> select_corner(const Context& context,
                                         deck::SourceLocation where,
                                         const deck::Selector& selector) {
  const BlockCorner found = nearest_corner(context.blocks, point_of(selector, 0));
  if (found.block >= 0)
    return found;
  error_nothing(context, where, selector, place_hint(context));
  return std::nullopt;
}

std::vector<int> blocks_named(const Context& context,
                              const deck::NumberOrSelector& named) {
  if (named.selector) {
    const std::vector<int> chosen =
        select_blocks(context, named.where(), *named.selector);
    note_selected(context, *named.selector, chosen);
    return chosen;
  }
  const int b = find_block_to_change(context, named.number);
  return b < 0 ? std::vector<int>{} : std::vector<int>{b};
}

int block_named(const Context& context, const deck::NumberOrSelector& named) {
  const std::vector<int> chosen = blocks_named(context, named);
  if (chosen.size() <= 1)
    return chosen.empty() ? -1 : chosen.front();
  error_several(context, named, counted(chosen.size(), "block"));
  return -1;
}

void error_several(const Context& context, const deck::NumberOrSelector& named,
                   const std::string& how_many) {
  if (!named.selector->is_by_position() || context.state.in_place)
    context.error(named.where(),
                  fmt::format("{} selects {}, and the card takes one",
                              named.selector->text, how_many),
                  "at(x, y) selects the block that contains a point");
}

SelectedSides sides_named(const Context& context, const deck::NumberOrSelector& block,
                          const deck::NumberOrSelector& side) {
  std::vector<int> chosen;
  if (block.given()) {
    chosen = blocks_named(context, block);
    if (chosen.empty())
      return {};
  }
  if (!side.selector) {
    SelectedSides out;
    for (const int b : chosen)
      if (const int its = find_side(context, b, side.number); its >= 0)
        out.sides.push_back({b, its});
    return out;
  }
  std::optional<SelectedSides> out =
      select_sides(context, side.where(), *side.selector);
  if (!out)
    return {};
  std::erase_if(out->sides, [&](const BlockSide& one) {
    return is_gone(context, one.block) ||
           (block.given() &&
            !std::binary_search(chosen.begin(), chosen.end(), one.block));
  });
  if (out->sides.empty())
    error_nothing(context, side.where(), *side.selector,
                  side.selector->by == By::joint
                      ? "joint ids are those of CUT, READ9, LAYER and CREATE"
                      : "both corners of a side must lie on the line");
  note_selected(context, *side.selector, out->sides);
  return *std::move(out);
}

}  // namespace blocks::run
