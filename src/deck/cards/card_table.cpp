#include "deck/cards/card_table.hpp"

#include <fmt/format.h>

#include "deck/cards/problem_cards.hpp"
#include "deck/free_field.hpp"
#include "deck/ranges.hpp"
#include "geometry/vec2.hpp"
#include "text/capitals.hpp"

namespace blocks::deck {
namespace {

constexpr Range a_number{1, 2147483647, false, false, false};

std::vector<CardSpec> preliminary_cards() {
  using enum Kind;
  std::vector<CardSpec> cards;
  const auto add = [&](CardSpec card) {
    card.group = CardGroup::preliminary;
    cards.push_back(std::move(card));
  };
  add({.name = "START",
       .once = true,
       .required = true,
       .section = "A.1.1",
       .summary = "first card of a new run: sizes and title",
       .fields = {{"nblok", integer, {}, from_one, "[-]", "maximum number of blocks"},
                  {"ncmx",
                   integer,
                   {},
                   {3, geometry::max_corners, false, false, false},
                   "[-]",
                   "maximum number of corners per block"}},
       .follow_on = {{"title", "title of the problem, one line, 80 characters"}},
       .notes = "Must be the first card. The line after it is always the title, even "
                "if it looks like a card.",
       .example = "START, 500, 40\nColumn of five blocks"});
  add({.name = "XLIMITS",
       .once = true,
       .required = true,
       .section = "A.1.2",
       .summary = "left and right end of the domain",
       .fields = {{"xmin", real, {}, any, "[L]", "least x of the domain"},
                  {"xmax", real, {}, any, "[L]", "greatest x of the domain, > xmin"}},
       .notes =
           "A block with a corner strictly outside the domain is fixed where it is.",
       .example = "XLIMITS, -10., 100."});
  add({.name = "YLIMITS",
       .once = true,
       .required = true,
       .section = "A.1.3",
       .summary = "lower and upper end of the domain",
       .fields = {{"ymin", real, {}, any, "[L]", "least y of the domain"},
                  {"ymax", real, {}, any, "[L]", "greatest y of the domain, > ymin"}},
       .example = "YLIMITS, -10., 40."});
  add({.name = "BOXES",
       .once = true,
       .required = true,
       .section = "A.1.4",
       .summary = "boxes of the contact search and contact tolerance",
       .fields = {{"iboxes", integer, {}, from_one, "[-]", "number of boxes along x"},
                  {"jboxes", integer, {}, from_one, "[-]", "number of boxes along y"},
                  {"ctol", real, "0.1", positive, "[L]",
                   "contact tolerance: least distance that corners move between two "
                   "searches for near pairs"}},
       .notes =
           "This card does not change the motion. It changes speed only if ctol is a "
           "large part of a block, because the search chooses its own cells and "
           "look-ahead. A good ctol is a tenth of a block, and less than half the "
           "shortest edge. A run becomes unsound if one step moves a corner by more "
           "than ctol and half the way to the middle of the shallowest block.",
       .example = "BOXES, 20, 10, .25"});
  add({.name = "STIFF",
       .once = true,
       .section = "A.1.5",
       .summary = "contact stiffness",
       .fields = {{"stifn", real, "1e6", positive, "[F/L]", "normal stiffness Kn"},
                  {"stifs", real, "1e6", positive, "[F/L]", "shear stiffness Ks"}},
       .notes = "Per unit thickness.",
       .example = "STIFF, 1.D7, 5.D6"});
  add({.name = "FRACTION",
       .once = true,
       .section = "A.1.6",
       .summary = "fraction of the critical time step",
       .fields = {{"tfrac",
                   real,
                   "",
                   {0, 1, true, false, false},
                   "[-]",
                   "time step divided by the critical time step of a single contact, "
                   "eq. (4); blank: the largest safe value"}},
       .notes =
           "A block with n contacts and DAMPING b is stable up to a FRACTION of "
           "(sqrt(1 + 3 n b^2) - b sqrt(3 n)) / sqrt(6 n). LOCDAMP alpha multiplies n "
           "by 1 + alpha. A warning is given above this value for n = 8, and an error "
           "above three times the value if several blocks are free. If tfrac is blank "
           "or the card is absent, the program takes this value for the contacts that "
           "each block may have, at least 8, and again when DAMPING or LOCDAMP "
           "changes.",
       .example = "FRACTION, .05"});
  add({.name = "MATERIAL",
       .required = true,
       .section = "A.1.7",
       .summary = "a material: elastic constants and density",
       .fields = {{"mat", integer, {}, a_number, "[-]", "material number"},
                  {"E", real, "0", not_negative, "[F/L^2]", "Young's modulus"},
                  {"G", real, "0", not_negative, "[F/L^2]", "shear modulus"},
                  {"rho", real, {}, positive, "[M/L^3]", "mass density"},
                  {"name", word, "", any, "",
                   "name shown in legends and kept by import and export (not in the "
                   "report)"}},
       .notes = "One card per material, in any number; the same number or name twice "
                "is an error. Quote a name that contains blanks or commas. A name has "
                "no colon and is not a whole number, because quantities such as "
                "y:material=NAME:max contain it. Blocks that deform (no RIGID card) "
                "need E > 0 and G > E/3.",
       .example = "MATERIAL, 1, 2.D10, 8.D9, 2300., sandstone"});
  add({.name = "FUNCTION",
       .once = true,
       .section = "A.1.8",
       .summary = "time function of PRESSBC and FORCE",
       .fields = {{"ntimep",
                   integer,
                   {},
                   from_one,
                   "[-]",
                   "number of points, one line each"}},
       .follow_on = {{"t, p",
                      "time [T] and value [-] of a point; ntimep lines, times "
                      "not decreasing; a time that is given again makes a step"}},
       .notes = "Linear between the points; constant before the first and after the "
                "last. Time is measured from the arrival time of each load.",
       .example = "FUNCTION, 3\n0., 0.\n1.D-3, 1.\n5.D-3, 0."});
  add({.name = "RIGID",
       .once = true,
       .section = "A.1.9",
       .summary = "blocks do not deform",
       .fields = {},
       .example = "RIGID"});
  add({.name = "SEED",
       .once = true,
       .section = "ours",
       .summary = "seed of the random numbers",
       .fields =
           {{"seed",
             integer,
             {},
             not_negative,
             "[-]",
             "seed of random layers and joints; the same seed gives the same blocks on "
             "every machine"}},
       .notes = "Without this card a fixed seed is used and printed.",
       .example = "SEED, 42"});
  add({.name = "UNITS",
       .once = true,
       .section = "ours",
       .summary = "units of the deck",
       .fields = {{"length", word, {}, any, "", "unit of length: m, mm, ft, ..."},
                  {"mass", word, {}, any, "", "unit of mass: kg, t, g, ..."},
                  {"time", word, {}, any, "", "unit of time: s, ms, d, ..."}},
       .notes = "Names the units in which all values of the deck are given; no value "
                "is converted. Results keep them, and figures, histories and pages "
                "show them. Other units than the usual ones are accepted with a "
                "warning: --units cannot convert them.",
       .example = "UNITS, m, kg, s"});
  add({.name = "END",
       .once = true,
       .required = true,
       .section = "A.1.10",
       .summary = "end of the preliminary data",
       .fields = {},
       .notes = "Not needed in a restart.",
       .example = "END"});
  add({.name = "RESTART",
       .once = true,
       .section = "A.1.11",
       .summary = "first card of a restart: continue an earlier run",
       .fields = {{"file", word, "", any, "",
                   "checkpoint to continue, or its name on a SAVE card (not in the "
                   "report); blank: NAME.ckpt.h5 of this run"}},
       .notes = "Must be the first card and is the only preliminary card of a restart. "
                "Quote a file name that contains blanks or commas.",
       .example = "RESTART, crater.ckpt.h5"});
  return cards;
}

}  // namespace

bool Range::contains(double value) const {
  const bool above = open_min ? value > min : value >= min;
  const bool below = open_max ? value < max : value <= max;
  return above && below && !(nonzero && value == 0.0);
}

std::string Range::text() const {
  std::string out;
  const auto add = [&](const std::string& part) {
    out += (out.empty() ? "" : " and ") + part;
  };
  if (min > -infinity) {
    add(fmt::format("{} {}", open_min ? ">" : ">=", min));
  }
  if (max < infinity) {
    add(fmt::format("{} {}", open_max ? "<" : "<=", max));
  }
  if (nonzero) {
    add("not 0");
  }
  return out;
}

std::string CardSpec::syntax() const {
  std::string out(name);
  for (const FieldSpec& field : fields) {
    out += ", ";
    out += field.name;
    if (field.repeats) {
      out += "1, " + std::string(field.name) + "2, ...";
    }
  }
  return out;
}

std::optional<std::size_t> CardSpec::find_field(std::string_view field) const {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (text::capitals(fields[i].name) == text::capitals(field)) {
      return i;
    }
  }
  return std::nullopt;
}

const std::vector<CardSpec>& card_table() {
  static const std::vector<CardSpec> table = [] {
    std::vector<CardSpec> cards = preliminary_cards();
    std::vector<CardSpec> problem = problem_cards();
    for (CardSpec& card : problem) {
      cards.push_back(std::move(card));
    }
    return cards;
  }();
  return table;
}

const CardSpec* find_card(std::string_view name) {
  const std::string wanted = text::capitals(name);
  for (const CardSpec& card : card_table()) {
    if (card.name == wanted) {
      return &card;
    }
  }
  return nullptr;
}

std::vector<std::string_view> card_names() {
  std::vector<std::string_view> names;
  for (const CardSpec& card : card_table()) {
    names.push_back(card.name);
  }
  return names;
}

}  // namespace blocks::deck
