#include "deck/cards/cards_text.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "deck/cards/card_descriptions.hpp"
#include "deck/cards/card_table.hpp"
#include "text/suggest.hpp"

namespace blocks::deck {
namespace {

constexpr std::size_t page_width = 80, markdown_width = 100;

/// Wraps a text into lines of at most `width`, each indented. No line begins with a
/// sign, which would begin a list in Markdown.
std::string wrapped(std::string_view text, std::size_t indent,
                    std::size_t width = page_width) {
  const std::string margin(indent, ' ');
  std::string out;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find(' '), text.size());
    const bool is_sign = length == 1 && (text.front() == '-' || text.front() == '+');
    if (column > 0 && column + 1 + length > width && !is_sign) {
      out += '\n';
      column = 0;
    }
    if (column == 0) {
      out += margin;
      column = indent;
    } else {
      out += ' ';
      ++column;
    }
    out += text.substr(0, length);
    column += length;
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return out + "\n";
}

/// Indents every line of a text.
std::string indented(std::string_view text, std::size_t indent) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    out += std::string(indent, ' ') + std::string(text.substr(0, length)) + "\n";
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return out;
}

std::string field_table(const CardSpec& card) {
  using Row = std::array<std::string, 5>;
  std::vector<Row> rows = {{"field", "kind", "default", "range", "unit"}};
  for (const FieldSpec& field : card.fields) {
    rows.push_back({std::string(field.name) + (field.repeats ? "1, ..." : ""),
                    std::string(kind_name(field.kind)), default_text(field),
                    range_text(field), std::string(field.dimension)});
  }
  std::array<std::size_t, 5> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string out;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string line = "  ";
    for (std::size_t i = 0; i < widths.size(); ++i) {
      line += fmt::format("{:<{}}  ", rows[r][i], widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
    if (r > 0) {
      out += wrapped(card.fields[r - 1].help, 6);
    }
  }
  return out;
}

/// Escapes a text for a Markdown table or paragraph.
std::string markdown(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '>' || c == '*') {
      out += '\\';
    }
    out += c;
  }
  return out;
}

/// Wraps a paragraph of a Markdown page.
std::string paragraph(std::string_view text) {
  return wrapped(text, 0, markdown_width);
}

std::string markdown_page(const CardSpec& card) {
  std::string out = fmt::format(
      "### {}\n\n{}\n```\n{}\n", card.name,
      paragraph(fmt::format("{} ({})", sentence(card.summary), occurrence_text(card))),
      card.syntax());
  for (const FollowOn& line : card.follow_on) {
    out += fmt::format("{}\n", line.syntax);
  }
  out += "```\n\n";
  if (!card.fields.empty()) {
    out += "| field | kind | default | range | unit | meaning |\n"
           "|---|---|---|---|---|---|\n";
    for (const FieldSpec& field : card.fields) {
      out += fmt::format("| `{}{}` | {} | {} | {} | {} | {} |\n", field.name,
                         field.repeats ? "1, ..." : "", kind_name(field.kind),
                         default_text(field), markdown(range_text(field)),
                         field.dimension, markdown(field.help));
    }
    out += "\n";
  }
  for (const FollowOn& line : card.follow_on) {
    out += paragraph(fmt::format("Then `{}`: {}.", line.syntax, markdown(line.help))) +
           "\n";
  }
  if (!card.notes.empty()) {
    out += paragraph(markdown(card.notes)) + "\n";
  }
  return out + fmt::format("Example:\n\n```\n{}\n```\n\n", card.example);
}

}  // namespace

std::string all_cards() {
  std::string out;
  for (const CardGroup group : {CardGroup::preliminary, CardGroup::problem}) {
    out += fmt::format("{}{}\n", out.empty() ? "" : "\n", group_title(group));
    for (const CardSpec& card : card_table()) {
      if (card.group == group) {
        out += fmt::format("  {:<9} {}{}\n", card.name, card.summary,
                           card.required ? " (required)" : "");
      }
    }
  }
  return out;
}

std::optional<std::string> card_page(std::string_view name) {
  const CardSpec* card = find_card(name);
  if (card == nullptr) {
    return std::nullopt;
  }
  std::string out = fmt::format("{}\n", card->syntax());
  for (const FollowOn& line : card->follow_on) {
    out += fmt::format("{}\n", line.syntax);
  }
  out += "\n" + wrapped(sentence(card->summary), 2);
  out += fmt::format("  ({})\n", occurrence_text(*card));
  if (!card->fields.empty()) {
    out += "\nFields\n" + field_table(*card);
  }
  if (!card->follow_on.empty()) {
    out += "\nLines that follow\n";
    for (const FollowOn& line : card->follow_on) {
      out += fmt::format("  {}\n", line.syntax) + wrapped(line.help, 6);
    }
  }
  if (!card->notes.empty()) {
    out += "\nNotes\n" + wrapped(card->notes, 2);
  }
  return out + "\nExample\n" + indented(card->example, 2);
}

std::string suggest_card(std::string_view name) {
  return text::suggest(name, card_names());
}

std::vector<std::string_view> reference_introduction() {
  return {
      "Free format: a card is a keyword, in upper or lower case, and its values, "
      "separated by commas or blanks. A blank field takes its default. Exponents are "
      "written with E or D. A $ or ! starts a comment; blank lines are skipped. A list "
      "of values may continue on further lines. The end of the deck acts as STOP.",
      "Kinds: \"whole\" is a whole number (3 or 3.0), \"real\" a number kept as the "
      "nearest double, \"decimal\" a number kept exactly as written because it "
      "describes geometry, \"word\" a text, within '...' or \"...\" if it contains "
      "blanks or commas. \"block\" and \"side\" are whole numbers or selectors, such "
      "as "
      "at(3, 4) or joint(2) (docs/selectors.md). Units are any consistent set, per "
      "unit "
      "thickness: L length, T time, M mass, F force."};
}

std::string card_reference_markdown() {
  std::string out = "# Deck reference\n\n";
  for (const std::string_view part : reference_introduction()) {
    out += paragraph(part) + "\n";
  }
  for (const CardGroup group : {CardGroup::preliminary, CardGroup::problem}) {
    out += fmt::format("## {}\n\n", group_title(group));
    for (const CardSpec& card : card_table()) {
      if (card.group == group) {
        out += markdown_page(card);
      }
    }
  }
  return out + "## The examples in one deck\n\n" +
         paragraph("Together the examples form a deck, which the tests run; `mine.msh` "
                   "contains two squares of material 1. The RESTART example continues "
                   "from its checkpoint.") +
         fmt::format("\n```\n{}```\n", all_examples());
}

std::string all_examples() {
  std::string deck;
  for (const CardSpec& card : card_table()) {
    if (card.name != "RESTART") {
      deck += fmt::format("{}\n", card.example);
    }
  }
  return deck;
}

}  // namespace blocks::deck
