#include "deck/cards/card_lists.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "deck/follow_on.hpp"

namespace blocks::deck {
namespace {

bool coordinates(Create& card, const std::vector<Line>& data, SourceLocation end,
                 const StartMaxima& maxima, Diagnostics& diagnostics) {
  if (maxima.corners && card.nc.value > *maxima.corners) {
    diagnostics.error(card.nc.where, "CREATE",
                      fmt::format("{} corners are more than START's maximum of {}",
                                  card.nc.value, *maxima.corners),
                      "raise ncmx, the second value of START, or correct nc");
    return false;
  }
  TwoLists lists =
      read_two_lists({"CREATE", card.nc.value, "x coordinates", "y coordinates",
                      FieldSpec{"coordinate ", Kind::exact, {}, {}, "[L]", ""}, false},
                     data, end, diagnostics);
  card.x = std::move(lists.first);
  card.y = std::move(lists.second);
  return lists.ok;
}

bool outline(Selection& blocks, std::string_view card, const std::vector<Line>& data,
             SourceLocation end, Diagnostics& diagnostics) {
  if (!blocks.nc.given) {
    if (!data.empty()) {
      diagnostics.error(data.front().fields.front().where, std::string(card),
                        "unexpected line of values after this card",
                        "coordinates of an outline follow only where nc is given");
    }
    return data.empty();
  }
  TwoLists lists =
      read_two_lists({card, blocks.nc.value, "x coordinates", "y coordinates",
                      FieldSpec{"coordinate ", Kind::exact, {}, {}, "[L]", ""}, false},
                     data, end, diagnostics);
  blocks.x = std::move(lists.first);
  blocks.y = std::move(lists.second);
  return lists.ok;
}

bool widths(Layer& card, const std::vector<Line>& data, SourceLocation end,
            const StartMaxima& maxima, Diagnostics& diagnostics) {
  if (card.ns.value < 0) {
    if (!data.empty()) {
      diagnostics.error(data.front().fields.front().where, "LAYER",
                        "unexpected line of values after this card",
                        "lists of widths follow only where ns > 0");
      return false;
    }
    return true;
  }
  if (maxima.blocks && card.ns.value > *maxima.blocks) {
    diagnostics.error(card.ns.where, "LAYER",
                      fmt::format("{} blocks are more than START's maximum of {}",
                                  card.ns.value, *maxima.blocks),
                      "raise nblok, the first value of START, or correct ns");
    return false;
  }
  Range positive;
  positive.min = 0;
  positive.open_min = true;
  TwoLists lists = read_two_lists(
      {"LAYER", card.ns.value, "bottom widths", "top widths",
       FieldSpec{"width ", Kind::exact, {}, positive, "[L]", "listed from the left"},
       true},
      data, end, diagnostics);
  card.bottom = std::move(lists.first);
  card.top = std::move(lists.second);
  return lists.ok;
}

}  // namespace

bool read_lists(Card& card, const std::vector<Line>& data, SourceLocation end,
                const StartMaxima& maxima, Diagnostics& diagnostics) {
  if (auto* create = std::get_if<Create>(&card)) {
    return coordinates(*create, data, end, maxima, diagnostics);
  }
  if (auto* layer = std::get_if<Layer>(&card)) {
    return widths(*layer, data, end, maxima, diagnostics);
  }
  if (auto* remove = std::get_if<Remove>(&card)) {
    return outline(remove->blocks, "REMOVE", data, end, diagnostics);
  }
  if (auto* free = std::get_if<Free>(&card)) {
    return outline(free->blocks, "FREE", data, end, diagnostics);
  }
  if (auto* function = std::get_if<Function>(&card)) {
    static const PointSpec spec{"FUNCTION",
                                "ntimep",
                                {"t", Kind::real, {}, {}, "[T]", "time"},
                                {"p", Kind::real, {}, {}, "[-]", "value"},
                                "times"};
    Points points = read_points(spec, function->ntimep.value, data, end, diagnostics);
    function->t = std::move(points.first);
    function->p = std::move(points.second);
    return points.ok;
  }
  if (auto* water = std::get_if<Water>(&card)) {
    static const PointSpec spec{"WATER",
                                "n",
                                {"x", Kind::real, {}, {}, "[L]", "x"},
                                {"y", Kind::real, {}, {}, "[L]", "y"}};
    Points points = read_points(spec, water->n.value, data, end, diagnostics);
    water->x = std::move(points.first);
    water->y = std::move(points.second);
    return points.ok;
  }
  return true;
}

}  // namespace blocks::deck
