#include "run/builder/names.hpp"

#include <algorithm>
#include <limits>

#include "dynamics/domain.hpp"
#include "quantities/curve_values.hpp"
#include "run/support/number_ranges.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

void error_no_block(const Context& context, const deck::Int& number) {
  const int count = context.blocks.size();
  // OUTPUT and HISTORY may name the blocks of later cards.
  const deck::Card& card = context.command.card;
  const bool anywhere = std::holds_alternative<deck::Output>(card) ||
                        std::holds_alternative<deck::History>(card);
  const long max =
      count + (anywhere
                   ? context.state.numbers.max_missing(std::numeric_limits<int>::max())
                   : context.max_missing());
  if (number.value > count && number.value <= max)
    return;
  context.error(number.where, fmt::format("there is no block {}", number.value),
                max == 0      ? "no block has been created so far"
                : max > count ? fmt::format("at most {} {} here", counted(max, "block"),
                                            max == 1 ? "exists" : "exist")
                : count == 1  ? std::string("only block 1 exists here")
                              : fmt::format("blocks 1 to {} exist here", count));
}

void error_no_material(const Context& context, deck::SourceLocation where,
                       const std::string& name) {
  std::vector<std::string> defined;
  for (const auto& [number, material] : context.settings.materials)
    defined.push_back(std::to_string(number) +
                      (material.name.empty() ? "" : " (" + material.name + ")"));
  context.error(where, "there is no material " + name,
                "materials defined: " + listed(defined));
}

}  // namespace

bool has_block(const Context& context, const deck::Int& number) {
  const BlockNumbers& numbers = context.state.numbers;
  const int count = context.blocks.size();
  if (numbers.is_unsure(number.value, count)) {
    context.error(number.where,
                  fmt::format("the block that gets the number {} is not known before "
                              "the run: blocks may split in the motion above",
                              number.value),
                  "make blocks before the motions in which others split, or name them "
                  "by material or outline");
    return false;
  }
  if (number.value >= 1 && number.value <= numbers.last(count))
    return true;
  error_no_block(context, number);
  return false;
}

namespace {

/// Returns the index of the block with this number. Returns -1 after an error, and for
/// a block that a faulty card has hidden.
int find_block(const Context& context, const deck::Int& number) {
  return has_block(context, number) ? context.state.numbers.index_of(number.value) : -1;
}

}  // namespace

int find_block_to_change(const Context& context, const deck::Int& number) {
  const int b = find_block(context, number);
  if (b < 0)
    return b;
  std::vector<int> chosen = {b};
  leave_out_removed(context, number.where, chosen);
  return chosen.empty() ? -1 : b;
}

std::vector<int> find_blocks(const Context& context, const deck::Int& nb1,
                             const deck::Int& nb2) {
  const int first = find_block(context, nb1);
  if (first < 0)
    return {};
  const int last = nb2.value < 0    ? context.blocks.size() - 1
                   : nb2.value == 0 ? first
                                    : find_block(context, nb2);
  std::vector<int> chosen;
  for (int b = first; b <= last; ++b)
    chosen.push_back(b);
  return chosen;
}

std::vector<int> find_blocks_of(const Context& context, const deck::Int& material) {
  if (!has_material(context, material))
    return {};
  const Blocks& blocks = context.blocks;
  std::vector<int> chosen;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.material[b] == material.value)
      chosen.push_back(b);
  if (chosen.empty() && context.max_missing() == 0)
    context.warning(material.where,
                    fmt::format("no block of material {} exists here", material.value),
                    place_hint(context));
  return chosen;
}

void leave_out_removed(const Context& context, deck::SourceLocation where,
                       std::vector<int>& chosen) {
  const auto is_removed = [&](int b) { return context.blocks.is_removed(b); };
  if (!chosen.empty() && std::all_of(chosen.begin(), chosen.end(), is_removed))
    context.warning(where,
                    blocks_are(context, chosen) + " removed, so the card has no effect",
                    "remove blocks after the cards that name them");
  std::erase_if(chosen, is_removed);
}

int find_side(const Context& context, int b, const deck::Int& number) {
  const int sides = context.blocks.corners_of(b);
  if (number.value >= 1 && number.value <= sides)
    return static_cast<int>(number.value) - 1;
  context.error(number.where, fmt::format("there is no side {}", number.value),
                fmt::format("block {} has sides 1 to {}",
                            context.state.numbers.number_of(b), sides));
  return -1;
}

bool can_move(const Context& context, int b, deck::SourceLocation where) {
  const Settings& settings = context.settings;
  const long number = context.state.numbers.number_of(b);
  if (context.blocks.fixity[b] == Fixity::left_domain) {
    context.warning(
        where, fmt::format("block {} is outside the domain and stays there", number),
        "widen the domain: XLIMITS, YLIMITS");
    return false;
  }
  const bool has_domain = (settings.lower.array() < settings.upper.array()).all();
  if (!has_domain || dynamics::is_inside_domain(context.blocks, b, settings))
    return true;
  context.error(
      where,
      fmt::format("block {} has a corner outside the domain, where no block moves",
                  number),
      "widen the domain: XLIMITS, YLIMITS");
  return false;
}

bool has_material(const Context& context, const deck::Int& number) {
  if (context.settings.materials.contains(static_cast<int>(number.value)))
    return true;
  if (!context.state.unread.may_define(number.value, context.settings))
    error_no_material(context, number.where, std::to_string(number.value));
  return false;
}

int find_material(const Context& context, deck::SourceLocation where,
                  const std::string& name) {
  const Settings& settings = context.settings;
  const UnreadCards& unread = context.state.unread;
  const int number =
      quantities::material_number(name, quantities::material_numbers(settings));
  if (settings.materials.contains(number))
    return number;
  if (!unread.may_define(number, settings) && !(number == 0 && unread.has("MATERIAL")))
    error_no_material(context, where, name);
  return 0;
}

std::string blocks_are(const Context& context, const std::vector<int>& blocks) {
  std::vector<int> numbered;
  for (const int b : blocks)
    numbered.push_back(static_cast<int>(context.state.numbers.number_of(b)) - 1);
  return blocks_are(numbered);
}

std::string place_hint(const Context& context) {
  return context.command.name + " takes effect at its place in the deck: put it after "
                                "the cards that make the blocks";
}

}  // namespace blocks::run
