// The blocks, sides and corners that cards name by selectors (docs/selectors.md).
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geometry/polygon.hpp"
#include "run/builder/builder.hpp"
#include "run/builder/history_card.hpp"
#include "run/support/number_ranges.hpp"
#include "text/counted.hpp"

namespace blocks::run {

using deck::Command;
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

}  // namespace

bool Builder::is_gone(int b) const {
  return model_.blocks.is_removed(b) || perhaps_removed_.contains(b);
}

std::string Builder::nearest_hint(const Vec2& point) const {
  const BlockCorner nearest = nearest_corner(model_.blocks, point);
  if (nearest.block < 0)
    return "no block exists here";
  const Vec2 at = model_.blocks.corner.col(model_.blocks.first_corner[nearest.block] +
                                           nearest.corner);
  return fmt::format("the nearest corner is that of block {} at ({:.6g}, {:.6g})",
                     missing_.number_of(nearest.block), at.x(), at.y());
}

void Builder::error_nothing(const Command& command, deck::SourceLocation where,
                            const deck::Selector& selector, std::string hint) {
  // Blocks may be elsewhere when the run gets here, or missing after an error.
  if ((selector.is_by_position() && !in_place_) || diagnostics_.has_errors() ||
      max_missing(command.where.line) > 0)
    return;
  const char* what = selector.by == By::nearest ? "corner"
                     : selector.is_of_sides()   ? "side"
                                                : "block";
  diagnostics_.error(
      where, command.name, fmt::format("{} selects no {}", selector.text, what),
      model_.blocks.count_present() == 0 ? place_hint(command) : std::move(hint));
}

int Builder::material_of(const Command& command, deck::SourceLocation where,
                         const deck::Selector& selector) {
  const int number =
      quantities::material_number(selector.material, material_numbers(model_.settings));
  if (model_.settings.materials.contains(number))
    return number;
  if (!unread_.may_define(number, model_.settings) &&
      !(number == 0 && unread_.has("MATERIAL")))
    error_no_material(command, where, selector.material);
  return 0;
}

std::vector<int> Builder::select(const Command& command, deck::SourceLocation where,
                                 const deck::Selector& selector) {
  const Blocks& blocks = model_.blocks;
  std::vector<int> chosen;
  std::string hint;
  if (selector.by == By::at) {
    const Vec2 point = point_of(selector, 0);
    if (const int b = block_at(blocks, point); b >= 0)
      chosen = {b};
    hint = nearest_hint(point);
  } else if (selector.by == By::in) {
    chosen = blocks_in(blocks, point_of(selector, 0), point_of(selector, 2));
    hint = "it selects blocks whose centroid is in the box between the two points";
  } else {
    const int material = material_of(command, where, selector);
    if (material == 0)
      return {};
    chosen = blocks::blocks_of_material(blocks, material);
    hint = fmt::format("no block of material {} exists here", material);
  }
  std::erase_if(chosen, [this](int b) { return is_gone(b); });
  if (chosen.empty())
    error_nothing(command, where, selector, std::move(hint));
  return chosen;
}

std::vector<int> Builder::blocks_named(const Command& command,
                                       const deck::NumberOrSelector& named) {
  if (named.selector) {
    const std::vector<int> chosen = select(command, named.where(), *named.selector);
    note_selected(command, *named.selector, "block", chosen);
    return chosen;
  }
  const int b = block_to_change(command, named.number);
  return b < 0 ? std::vector<int>{} : std::vector<int>{b};
}

int Builder::block_named(const Command& command, const deck::NumberOrSelector& named) {
  const std::vector<int> chosen = blocks_named(command, named);
  if (chosen.size() <= 1)
    return chosen.empty() ? -1 : chosen.front();
  error_several(command, named, counted(chosen.size(), "block"));
  return -1;
}

void Builder::error_several(const Command& command, const deck::NumberOrSelector& named,
                            const std::string& how_many) {
  if (!named.selector->is_by_position() || in_place_)
    diagnostics_.error(named.where(), command.name,
                       fmt::format("{} selects {}, and the card takes one",
                                   named.selector->text, how_many),
                       "at(x, y) selects the block that contains a point");
}

std::optional<SelectedSides> Builder::select_sides(const Command& command,
                                                   deck::SourceLocation where,
                                                   const deck::Selector& selector) {
  const Blocks& blocks = model_.blocks;
  const double tolerance = has_moved() ? model_.settings.contact_tolerance : 0.0;
  if (selector.by == By::joint)
    return SelectedSides{
        sides_of_joint(blocks, static_cast<int>(selector.numbers[0].value())), {}};
  if (selector.by == By::on) {
    const Plane line{point_of(selector, 0), point_of(selector, 2)};
    return SelectedSides{sides_on(blocks, line.a, line.b, SidesOf::both, tolerance),
                         line};
  }
  const auto k = static_cast<std::size_t>(selector.numbers[0].value());
  if (last_outline_.empty() && (unread_.has("CUT") || failed_blocks_ > 0))
    return std::nullopt;
  if (k > last_outline_.size()) {
    diagnostics_.error(
        where, command.name,
        last_outline_.empty() ? "no OUTLINE above has edges"
                              : fmt::format("the outline has no edge {}", k),
        last_outline_.empty()
            ? "on(x1, y1, x2, y2) selects sides on a line"
            : fmt::format("it has edges 1 to {}; edge i runs from corner i to i + 1",
                          last_outline_.size()));
    return std::nullopt;
  }
  const Plane line{last_outline_[k - 1], last_outline_[k % last_outline_.size()]};
  const bool anticlockwise = geometry::check_outline(last_outline_).anticlockwise;
  return SelectedSides{sides_on(blocks, line.a, line.b,
                                anticlockwise ? SidesOf::left : SidesOf::right,
                                tolerance),
                       line};
}

SelectedSides Builder::sides_named(const Command& command,
                                   const deck::NumberOrSelector& block,
                                   const deck::NumberOrSelector& side) {
  std::vector<int> chosen;
  if (block.given()) {
    chosen = blocks_named(command, block);
    if (chosen.empty())
      return {};
  }
  if (!side.selector) {
    SelectedSides out;
    for (const int b : chosen)
      if (const int its = this->side(command, b, side.number); its >= 0)
        out.sides.push_back({b, its});
    return out;
  }
  std::optional<SelectedSides> out =
      select_sides(command, side.where(), *side.selector);
  if (!out)
    return {};
  std::erase_if(out->sides, [&](const BlockSide& one) {
    return is_gone(one.block) ||
           (block.given() &&
            !std::binary_search(chosen.begin(), chosen.end(), one.block));
  });
  if (out->sides.empty())
    error_nothing(command, side.where(), *side.selector,
                  side.selector->by == By::joint
                      ? "joint ids are those of CUT, READ9, LAYER and CREATE"
                      : "both corners of a side must lie on the line");
  note_selected_sides(command, *side.selector, out->sides);
  return *std::move(out);
}

std::string Builder::time_of_note() const {
  return in_place_ ? fmt::format(" at time {:g}", model_.time)
                   : std::string(", if nothing moves before");
}

void Builder::note_selected(const Command& command, const deck::Selector& selector,
                            const std::string& what, const std::vector<int>& chosen) {
  if (chosen.empty())
    return;
  const bool one = chosen.size() == 1;
  notes_.push_back(fmt::format("{} in line {}{}: {} selects {}{}", command.name,
                               command.where.line, time_of_note(), selector.text,
                               one ? what + " " : counted(chosen.size(), what) + ": ",
                               number_ranges(chosen)));
}

void Builder::note_selected_sides(const Command& command,
                                  const deck::Selector& selector,
                                  const std::vector<BlockSide>& sides) {
  if (sides.empty())
    return;
  const std::vector<int> blocks = blocks_of(sides);
  notes_.push_back(
      fmt::format("{} in line {}{}: {} selects {} of {} {}", command.name,
                  command.where.line, time_of_note(), selector.text,
                  sides.size() == 1 ? fmt::format("side {}", sides[0].side + 1)
                                    : counted(sides.size(), "side"),
                  blocks.size() == 1 ? "block" : "blocks", number_ranges(blocks)));
}

std::vector<int> Builder::output_blocks(const Command& command,
                                        const deck::Output& card) {
  constexpr long max = std::numeric_limits<int>::max();
  std::vector<int> chosen;
  for (const deck::NumberOrSelector& named : card.blocks) {
    if (!named.selector) {
      chosen.push_back(static_cast<int>(std::clamp(named.number.value, 1L, max)) - 1);
      continue;
    }
    for (const int b : blocks_named(command, named))
      if (std::find(chosen.begin(), chosen.end(), b) == chosen.end())
        chosen.push_back(b);
  }
  return chosen;
}

std::string Builder::place_of(const Command& command, deck::SourceLocation where,
                              const deck::Selector& selector) {
  if (selector.by == By::material)
    return "material=" + selector.material;
  if (selector.by == By::joint)
    return fmt::format("joint={:g}", selector.numbers[0].value());
  if (selector.by == By::nearest) {
    const BlockCorner found = nearest_corner(model_.blocks, point_of(selector, 0));
    if (found.block < 0)
      error_nothing(command, where, selector, place_hint(command));
    return found.block < 0 ? std::string()
                           : fmt::format("{}.{}", missing_.number_of(found.block),
                                         found.corner + 1);
  }
  if (selector.is_of_sides()) {
    diagnostics_.error(
        where, command.name,
        fmt::format("{} names sides, which have no history", selector.text),
        fmt::format("blocks: {}; a corner: nearest(x, y); a joint: "
                    "joint(id)",
                    deck::block_selectors));
    return {};
  }
  const std::vector<int> chosen = select(command, where, selector);
  if (chosen.empty())
    return {};
  if (selector.by == By::at)
    return std::to_string(chosen.front() + 1);
  return quantities::place_of_blocks(chosen);
}

Command Builder::with_numbers(const Command& command) {
  Command out = command;
  auto& words = std::get<deck::History>(out.card).quantities;
  const bool any = !words.empty();
  for (deck::Word& word : words) {
    const std::size_t colon = word.value.find(':'), close = word.value.find(')');
    const std::string place =
        colon == std::string::npos ? std::string() : word.value.substr(colon + 1);
    if (!deck::looks_like_selector(place))
      continue;
    const std::size_t end = std::min(close, word.value.size() - 1) + 1;
    try {
      const deck::Selector selector =
          deck::read_selector(word.value.substr(colon + 1, end - colon - 1));
      const std::string numbers = place_of(command, word.where, selector);
      const std::string named =
          word.value.substr(0, colon + 1) + numbers + word.value.substr(end);
      if (!numbers.empty() && selector.is_by_position())
        notes_.push_back(fmt::format("{} in line {}{}: {} is {}", command.name,
                                     command.where.line, time_of_note(), word.value,
                                     named));
      word.value = numbers.empty() ? "" : named;
    } catch (const deck::SelectorFault& fault) {
      diagnostics_.error(word.where, command.name, fault.what(), fault.hint);
      word.value.clear();
    }
  }
  std::erase_if(words, [](const deck::Word& word) { return word.value.empty(); });
  if (any && words.empty())  // The card must not seem to name no quantities.
    words.push_back({quantities::usual_curves[0], command.where, true});
  return out;
}

}  // namespace blocks::run
