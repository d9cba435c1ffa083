#include "dblock/cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string_view>

#include "deck/free_field.hpp"
#include "text/capitals.hpp"
#include "text/counted.hpp"
#include "text/suggest.hpp"

namespace blocks::dblock {
namespace {

/// One card: how many numbers follow it, and the function that applies them.
struct Card {
  std::size_t min, max;
  std::function<void(Cards&, const std::vector<double>&)> act;
  bool whole = false;  ///< numbers are whole, 1 or more
};

/// The colours of Table E.2.
const std::map<std::string, draw::Colour, std::less<>>& colours() {
  static const std::map<std::string, draw::Colour, std::less<>> all = {
      {"CLEARC", {1, 1, 1}},
      {"BLUE", {0.16, 0.35, 0.80}},
      {"CYAN", {0.35, 0.80, 0.85}},
      {"GREEN", {0.25, 0.62, 0.32}},
      {"MGENTA", {0.78, 0.25, 0.65}},
      {"RED", {0.82, 0.20, 0.18}},
      {"YELLOW", {0.96, 0.85, 0.25}},
      {"ZUNI", {0.45, 0.70, 0.92}}};  // Sandia light blue
  return all;
}

Card colour_card(const draw::Colour& colour) {
  return {1, 1,
          [=](Cards& cards, const std::vector<double>& v) {
            cards.materials[static_cast<int>(v[0])] = colour;
          },
          true};
}

const std::map<std::string, Card, std::less<>>& table() {
  using C = Cards;
  using Values = std::vector<double>;
  constexpr std::size_t any = 1000;
  static std::map<std::string, Card, std::less<>> cards = {
      {"BLOCKS", {0, 0, [](C& c, const Values&) { c.first_only = true; }}},
      {"ZOOM",
       {4, 4,
        [](C& c, const Values& v) {
          c.zoom = Eigen::Vector4d(v[0], v[1], v[2], v[3]);
        }}},
      {"FRAMESIZE",
       {1, 1, [](C& c, const Values& v) { c.frame_size = static_cast<int>(v[0]); },
        true}},
      {"PRINT", {0, 0, [](C& c, const Values&) { c.print = true; }}},
      {"NTIMES",
       {0, 1,
        [](C& c, const Values& v) {
          c.count = v.empty() ? 10 : static_cast<int>(v[0]);
        },
        true}},
      {"ALLTIMES", {0, 0, [](C& c, const Values&) { c.all_times = true; }}},
      {"TMIN", {1, 1, [](C& c, const Values& v) { c.from = v[0]; }}},
      {"TMAX", {1, 1, [](C& c, const Values& v) { c.to = v[0]; }}},
      {"DELTIME", {1, 1, [](C& c, const Values& v) { c.every = v[0]; }}},
      {"TIMES",
       {1, any,
        [](C& c, const Values& v) {
          c.times.insert(c.times.end(), v.begin(), v.end());
        }}},
      {"MOVIE", {0, 0, [](C& c, const Values&) { c.movie = true; }}},
      {"FLIP", {0, 0, [](C& c, const Values&) { c.flip = true; }}},
      {"ENDDATA", {0, 0, [](C&, const Values&) {}}}};
  for (const auto& [name, colour] : colours())
    cards.try_emplace(name, colour_card(colour));
  return cards;
}

std::vector<std::string_view> names() {
  std::vector<std::string_view> all;
  for (const auto& [name, card] : table())
    all.emplace_back(name);
  return all;
}

/// Reads the numbers that follow the card; returns nothing if one of them is invalid.
std::optional<std::vector<double>> numbers(const deck::Line& line,
                                           const std::string& name, const Card& card,
                                           deck::Diagnostics& faults) {
  std::vector<double> values;
  bool sound = true;
  for (std::size_t i = 1; i < line.fields.size(); ++i) {
    const deck::Field& field = line.fields[i];
    const deck::Number number = deck::read_number(field.text);
    const double value = number.value.value();
    if (field.blank || number.fault != deck::NumberFault::none) {
      faults.error(field.where, name, "expected a number, found '" + field.text + "'");
      sound = false;
    } else if (card.whole && (value < 1 || value > 1e6 || value != std::floor(value))) {
      faults.error(field.where, name,
                   "expected a whole number from 1 to 1000000, found " + field.text);
      sound = false;
    }
    values.push_back(value);
  }
  if (values.size() < card.min || values.size() > card.max) {
    faults.error(line.fields.front().where, name,
                 card.min == card.max
                     ? fmt::format("expected {}, found {}",
                                   counted(card.min, "number"), values.size())
                     : fmt::format("expected {} to {} numbers, found {}", card.min,
                                   card.max, values.size()));
    sound = false;
  }
  return sound ? std::optional(values) : std::nullopt;
}

}  // namespace

std::optional<draw::Colour> named_colour(const std::string& name) {
  if (const auto found = colours().find(text::capitals(name)); found != colours().end())
    return found->second;
  if (name.size() != 7 || name[0] != '#' ||
      name.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
    return {};
  const auto part = [&](std::size_t at) {
    return std::stoi(name.substr(at, 2), nullptr, 16) / 255.0;
  };
  return draw::Colour{part(1), part(3), part(5)};
}

std::string colour_names() {
  std::string text;
  for (const auto& [name, colour] : colours())
    text += name + ", ";
  return text + "#rrggbb";
}

Cards read_cards(const std::string& text, deck::Diagnostics& faults) {
  Cards cards;
  if (const auto where = deck::first_binary_byte(text)) {
    faults.error(*where, "", "not a text file: a control character",
                 "DBLOCK cards are plain text, such as TIMES, 0, 1");
    return cards;
  }
  for (const deck::Line& line : deck::split_deck(text)) {
    const deck::Field& head = line.fields.front();
    const std::string name = text::capitals(head.text);
    const auto found = table().find(name);
    if (found == table().end()) {
      const std::string near = text::suggest(name, names());
      faults.error(head.where, {}, "DBLOCK has no card '" + head.text + "'",
                   near.empty()
                       ? fmt::format("its cards are {}", fmt::join(names(), ", "))
                       : "did you mean " + near + "?");
      continue;
    }
    const auto values = numbers(line, name, found->second, faults);
    if (!values)
      continue;
    found->second.act(cards, *values);
    if (colours().contains(name))
      cards.painted[static_cast<int>(values->front())] = {line.fields[1].where, name};
    if (name == "ENDDATA")
      break;
    if (name == "FRAMESIZE" && cards.frame_size > 3)
      faults.error(line.fields[1].where, name, "expected 1, 2 or 3");
    if (name == "ZOOM" &&
        !((*cards.zoom)[0] < (*cards.zoom)[1] && (*cards.zoom)[2] < (*cards.zoom)[3]))
      faults.error(head.where, name, "expected xmin < xmax and ymin < ymax");
    if (name == "DELTIME" && !(*cards.every > 0.0))
      faults.error(line.fields[1].where, name, "expected a number above 0");
  }
  if (cards.movie)
    cards.frame_size = 3;
  return cards;
}

std::vector<double> Cards::chosen(const std::vector<double>& all) const {
  if (first_only)
    return {all.front()};
  // Clip the range to the results. The times of TIMES are not clipped; they must exist.
  const double low = std::max(from.value_or(all.front()), all.front()),
               high = std::min(to.value_or(all.back()), all.back());
  std::set<double> found(times.begin(), times.end());
  // If DELTIME is shorter than any spacing of results, take all results in the range.
  const bool dense = every && (high - low) / *every > 1e5;
  if (all_times || dense)
    for (const double t : all)
      if (t >= low && t <= high)
        found.insert(t);
  if (low > high)
    return {found.begin(), found.end()};
  if (every && !dense)
    for (int k = 0; low + k * *every <= high + 1e-9 * *every; ++k)
      found.insert(std::min(low + k * *every, high));
  if (count || (times.empty() && !all_times && !every)) {
    const int n = count.value_or(10);
    for (int k = 0; k < n; ++k)
      found.insert(n == 1 ? low : low + (high - low) * k / (n - 1));
  }
  return {found.begin(), found.end()};
}

}  // namespace blocks::dblock
