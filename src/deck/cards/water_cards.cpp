#include "deck/cards/water_cards.hpp"

#include "deck/commands.hpp"
#include "deck/ranges.hpp"

namespace blocks::deck {
namespace {

constexpr Range up_to_many{0, 100000, false, false, false};

}  // namespace

std::vector<CardSpec> water_cards() {
  using enum Kind;
  return {
      {.name = "WATER",
       .section = "ours",
       .summary = "water table: water at rest in joints and on faces",
       .fields = {{"gamma", real, "0", not_negative, "[F/L^3]",
                   "weight of the water; blank only if n is 0"},
                  {"n",
                   integer,
                   {},
                   up_to_many,
                   "[-]",
                   "number of points, one line each; 0: no table"},
                  {"tramp", real, "0", not_negative, "[T]",
                   "time in which the table moves here from where it is"}},
       .follow_on =
           {{"x, y",
             "a point of the table [L]; n lines, in the order of x; linear between "
             "the points and level beyond them"}},
       .notes =
           "Each side of a block carries the pressure gamma times the depth below the "
           "table, wherever it lies below it: in closed and open joints, and on outer "
           "faces. Forces of contacts become effective forces. Depth is measured along "
           "the gravity of the GRAVITY card above, or along y; then x is measured "
           "across it. With tramp the levels change linearly; the first table rises "
           "from the lowest corner of the model. Another WATER card replaces the "
           "table.",
       .example = "WATER, 9810., 2\n0., 12.\n40., 3."},
      {.name = "JWATER",
       .section = "ours",
       .summary = "pressure of water in the joints of an id",
       .fields =
           {{"id",
             integer,
             {},
             id_or_none,
             "[-]",
             "joint id of the sides; 0: sides without one, as on outlines"},
            {"x1", real, "0", any, "[L]", "point 1"},
            {"y1", real, "0", any, "[L]", "point 1"},
            {"p1", real, "0", not_negative, "[F/L^2]", "pressure at point 1"},
            {"x2", real, "0", any, "[L]", "point 2"},
            {"y2", real, "0", any, "[L]", "point 2"},
            {"p2", real, "0", not_negative, "[F/L^2]", "pressure at point 2"},
            {"reach", real, "", positive, "[L]",
             "the pressure acts on sides up to this distance from the line; blank: "
             "a hundredth of its length"},
            {"tramp", real, "0", not_negative, "[T]",
             "time in which it takes the place of the table's pressure"}},
       .notes =
           "The sides of the id carry this pressure in place of that of the table of "
           "WATER. It is linear from point 1 to point 2, and acts where a "
           "side lies between them, within reach of the line: a side that has moved "
           "away "
           "has left the water. Several cards of an id add up. With the id only, "
           "its sides are dry, and its cards before have no effect.",
       .example = "JWATER, 3, 8., 3., 4.9D4, 14., 6., 0."},
  };
}

std::optional<Card> build_water(const std::vector<Value>& f, Diagnostics& diagnostics) {
  Water card{f[0].as_real(), f[1].as_int(), f[2].as_real(), {}, {}};
  if (card.n.value > 0 && card.gamma.value == 0.0) {
    diagnostics.error(card.gamma.where, "WATER",
                      "the table needs the weight of the water",
                      "gamma is 9810 in N and m");
    return {};
  }
  return card;
}

std::optional<Card> build_joint_water(const std::vector<Value>& f,
                                      Diagnostics& diagnostics) {
  Jwater card{f[0].as_int(),  f[1].as_real(), f[2].as_real(),
              f[3].as_real(), f[4].as_real(), f[5].as_real(),
              f[6].as_real(), f[7].as_real(), f[8].as_real()};
  const bool one_point =
      card.x1.value == card.x2.value && card.y1.value == card.y2.value;
  const bool has_points = card.x1.given || card.y1.given || card.x2.given ||
                          card.y2.given || card.reach.given;
  if (has_points && !card.p1.given && !card.p2.given) {
    diagnostics.error(card.x1.given ? card.x1.where : card.id.where, "JWATER",
                      "there are points, but no pressure",
                      "give p1 at (x1, y1) and p2 at (x2, y2); with the id only, its "
                      "sides are dry");
    return {};
  }
  if (card.presses() && one_point) {
    diagnostics.error(card.x2.given ? card.x2.where : card.p1.where, "JWATER",
                      "the pressure needs two different points",
                      "it is linear from (x1, y1) to (x2, y2), for example the ends of "
                      "the joint; without p1 and p2 the joint is dry");
    return {};
  }
  return card;
}

}  // namespace blocks::deck
