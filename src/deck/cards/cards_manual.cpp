#include "deck/cards/cards_manual.hpp"

#include <fmt/format.h>

#include "deck/cards/card_descriptions.hpp"
#include "deck/cards/card_table.hpp"
#include "deck/cards/cards_text.hpp"
#include "text/roff.hpp"

namespace blocks::deck {
namespace {

namespace roff = text::roff;

std::string field_item(const FieldSpec& field) {
  const std::string name = std::string(field.name) + (field.repeats ? "1, ..." : "");
  std::string facts = fmt::format("{}; ", kind_name(field.kind));
  facts += field.fallback ? "default " + default_text(field) : default_text(field);
  if (const std::string range = range_text(field); range != "any")
    facts += "; " + range;
  if (!field.dimension.empty())
    facts += fmt::format("; {}", field.dimension);
  return roff::item(roff::italic(name), fmt::format("{} ({})", field.help, facts));
}

std::string page_of(const CardSpec& card) {
  std::string lines = card.syntax();
  for (const FollowOn& line : card.follow_on)
    lines += fmt::format("\n{}", line.syntax);
  std::string out = roff::subsection(card.name) + roff::example(lines) +
                    roff::paragraph(fmt::format("{} ({})", sentence(card.summary),
                                                occurrence_text(card)));
  for (const FieldSpec& field : card.fields)
    out += field_item(field);
  for (const FollowOn& line : card.follow_on)
    out += roff::item(roff::italic(line.syntax), line.help);
  if (!card.notes.empty())
    out += roff::paragraph(card.notes);
  return out + roff::paragraph("Example:") + roff::example(card.example);
}

}  // namespace

std::string card_reference_man(std::string_view version) {
  std::string out = roff::head("blocks-deck", 5, version, "File formats",
                               "cards of a deck of the block motion code blocks(1)") +
                    roff::section("Description");
  for (const std::string_view part : reference_introduction())
    out += roff::paragraph(part);
  for (const CardGroup group : {CardGroup::preliminary, CardGroup::problem}) {
    out += roff::section(group_title(group));
    for (const CardSpec& card : card_table())
      if (card.group == group)
        out += page_of(card);
  }
  return out + roff::section("See also") + roff::bold("blocks") + "(1)\n";
}

}  // namespace blocks::deck
