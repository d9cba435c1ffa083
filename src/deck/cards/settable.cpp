#include "deck/cards/settable.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "deck/card_reader.hpp"

namespace blocks::deck {
namespace {

/// Returns the text of a value, in quotes if it would otherwise be split.
std::string as_written(const Field& field) {
  const bool needs_quotes = field.text.find_first_of(" \t,$!") != std::string::npos ||
                            field.text.find_first_of("'\"") == 0;
  const char quote = field.text.find('\'') == std::string::npos ? '\'' : '"';
  return needs_quotes ? quote + field.text + quote : field.text;
}

/// Returns the value of field `at` of a card, as written or the default. A field that
/// repeats has all its values.
std::string value_of(const CardSpec& spec, const Line& line, std::size_t at) {
  const std::size_t begin = at + 1;  // after the keyword
  const std::size_t end = spec.fields[at].repeats ? line.fields.size() : begin + 1;
  std::string values;
  for (std::size_t i = begin; i < end && i < line.fields.size(); ++i)
    if (!line.fields[i].blank)
      values += (values.empty() ? "" : ",") + as_written(line.fields[i]);
  return values.empty() ? std::string(spec.fields[at].fallback.value_or("")) : values;
}

}  // namespace

std::vector<std::string> settable_fields(std::string_view text) {
  const std::vector<Line> lines = split_deck(text);
  std::vector<std::pair<const CardSpec*, Line>> cards;
  std::map<const CardSpec*, long> all, met;
  for (std::size_t next = 0; next < lines.size();) {
    const CardSpec* spec = find_card(lines[next].fields.front().text);
    if (spec == nullptr) {  // a line of values
      ++next;
      continue;
    }
    cards.emplace_back(spec, take_card(*spec, lines, next));
    ++all[spec];
    if (spec->name == "STOP")
      break;
  }
  std::vector<std::string> out;
  for (const auto& [spec, line] : cards) {
    const long number = ++met[spec];
    const std::string card = all[spec] == 1 ? std::string(spec->name)
                                            : fmt::format("{}[{}]", spec->name, number);
    for (std::size_t i = 0; i < spec->fields.size(); ++i)
      out.push_back(fmt::format("{}.{}={}", card, spec->fields[i].name,
                                value_of(*spec, line, i)));
  }
  return out;
}

}  // namespace blocks::deck
