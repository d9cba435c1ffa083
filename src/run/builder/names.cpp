// The blocks and materials that cards name by their numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "run/builder/builder.hpp"
#include "run/support/number_ranges.hpp"

namespace blocks::run {

using deck::Command;

int Builder::block(const Command& command, const deck::Int& number) {
  if (is_unsure(number.value)) {
    error_unsure(command, number);
    return -1;
  }
  if (number.value >= 1 && number.value <= last_number()) {
    const auto b = static_cast<int>(missing_.index_of(number.value));
    return b < certain_blocks_ ? b : -1;
  }
  error_no_block(command, number);
  return -1;
}

int Builder::block_to_change(const Command& command, const deck::Int& number) {
  const int b = block(command, number);
  if (b < 0)
    return b;
  std::vector<int> chosen = {b};
  leave_out_removed(command, number.where, chosen);
  return chosen.empty() ? -1 : b;
}

std::string Builder::place_hint(const Command& command) {
  return command.name + " takes effect at its place in the deck: put it after the "
                        "cards that make the blocks";
}

std::vector<int> Builder::blocks_in_range(const Command& command, const deck::Int& nb1,
                                          const deck::Int& nb2) {
  const int first = block(command, nb1);
  if (first < 0)
    return {};
  const int last = nb2.value < 0    ? model_.blocks.size() - 1
                   : nb2.value == 0 ? first
                                    : block(command, nb2);
  std::vector<int> chosen;
  for (int b = first; b <= last; ++b)
    chosen.push_back(b);
  return chosen;
}

std::vector<int> Builder::blocks_of_material(const Command& command,
                                             const deck::Int& material) {
  if (!has_material(command, material))
    return {};
  const Blocks& blocks = model_.blocks;
  std::vector<int> chosen;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.material[b] == material.value)
      chosen.push_back(b);
  if (chosen.empty() && max_missing(command.where.line) == 0)
    diagnostics_.warning(
        material.where, command.name,
        fmt::format("no block of material {} exists here", material.value),
        place_hint(command));
  return chosen;
}

void Builder::leave_out_removed(const Command& command, deck::SourceLocation where,
                                std::vector<int>& chosen) {
  const auto is_removed = [&](int b) { return model_.blocks.is_removed(b); };
  if (!chosen.empty() && std::all_of(chosen.begin(), chosen.end(), is_removed))
    diagnostics_.warning(
        where, command.name,
        fmt::format("{} removed, so the card has no effect", blocks_are(chosen)),
        "remove blocks after the cards that name them");
  std::erase_if(chosen, is_removed);
}

bool Builder::has_material(const Command& command, const deck::Int& number) {
  const Settings& settings = model_.settings;
  if (settings.materials.contains(static_cast<int>(number.value)))
    return true;
  if (unread_.may_define(number.value, settings))
    return false;
  error_no_material(command, number.where, std::to_string(number.value));
  return false;
}

void Builder::error_no_material(const Command& command, deck::SourceLocation where,
                                const std::string& given) {
  std::string known;
  for (const auto& [mat, material] : model_.settings.materials)
    known += (known.empty() ? "" : ", ") + std::to_string(mat) +
             (material.name.empty() ? "" : " (" + material.name + ")");
  diagnostics_.error(where, command.name, "there is no material " + given,
                     "materials defined: " +
                         (known.empty() ? std::string("none") : known));
}

long Builder::max_missing(int line) const {
  return failed_blocks_ + unread_.max_blocks_above(line);
}

void Builder::count_blocks(int line) {
  for (; const deck::UnreadCard* card = unread_.above(line, unread_counted_);
       ++unread_counted_)
    if (card->name == "CREATE")
      missing_.add(model_.blocks.size(), card->blocks);
  if (max_missing(line) == missing_.count())
    certain_blocks_ = model_.blocks.size();
}

std::string Builder::blocks_are(const std::vector<int>& blocks) const {
  std::vector<int> numbered;
  for (const int b : blocks)
    numbered.push_back(static_cast<int>(missing_.number_of(b)) - 1);
  return run::blocks_are(numbered);
}

}  // namespace blocks::run
