#include "run/builder/deck_outlines.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

#include "deck/points.hpp"

namespace blocks::run {
namespace {

constexpr long max_at_once =
    20'000'000;  // more copies than this or START allow are an error

geometry::DeckOutline outline_of(const deck::Layer& card) {
  geometry::DeckOutline outline;
  for (std::size_t i = 0; i < 4; ++i)
    outline.corners.push_back(
        {card.corners[2 * i].value, card.corners[2 * i + 1].value});
  return outline;
}

geometry::DeckOutline outline_of(const deck::Cut& card) {
  return {deck::points_of(card.outline.x, card.outline.y), {}};
}

}  // namespace

geometry::DeckOutline outline_of(const deck::Create& card) {
  geometry::DeckOutline outline{deck::points_of(card.x, card.y), {}};
  if (card.loop) {
    outline.shift = {card.loop->radd.value, card.loop->zadd.value};
    outline.copies = static_cast<int>(card.loop->nloop.value);
  }
  return outline;
}

std::vector<geometry::SharedCorners>
shared_corners(const std::vector<deck::Command>& cards) {
  std::vector<geometry::SharedCorners> sections;
  std::vector<geometry::DeckOutline> outlines;
  long max_blocks = max_at_once;
  const auto close = [&] {
    sections.emplace_back(outlines);
    outlines.clear();
  };
  for (const deck::Command& command : cards) {
    if (const auto* start = std::get_if<deck::Start>(&command.card))
      max_blocks = std::min(start->nblok.value, max_at_once);
    else if (const auto* layer = std::get_if<deck::Layer>(&command.card))
      outlines.push_back(outline_of(*layer));
    else if (const auto* cut = std::get_if<deck::Cut>(&command.card))
      outlines.push_back(outline_of(*cut));
    else if (const auto* create = std::get_if<deck::Create>(&command.card);
             create != nullptr &&
             (!create->loop || create->loop->nloop.value <= max_blocks))
      outlines.push_back(outline_of(*create));
    else if (deck::passes_time(command))
      close();
  }
  close();
  return sections;
}

}  // namespace blocks::run
