#include "deck/cards/problem_cards.hpp"

#include "deck/cards/block_cards.hpp"
#include "deck/cards/crack_cards.hpp"
#include "deck/cards/joint_cards.hpp"
#include "deck/cards/law_cards.hpp"
#include "deck/cards/rest_cards.hpp"
#include "deck/cards/water_cards.hpp"
#include "deck/ranges.hpp"
#include "geometry/vec2.hpp"

namespace blocks::deck {
namespace {

constexpr Range corners{3, geometry::max_corners, false, false, false};

/// The fields of REMOVE and FREE.
std::vector<FieldSpec> selection_fields() {
  using enum Kind;
  return {{"nb1", block, "", from_one, "[-]", "block number or selector"},
          {"nb2", integer, "", any, "[-]",
           "0 or nb1: block nb1 alone; > nb1: nb1 to nb2; < 0: nb1 to the last so far"},
          {"mat", integer, "", from_one, "[-]", "all blocks of this material"},
          {"nc", integer, "", corners, "[-]",
           "all blocks inside an outline of nc corners, which follows"},
          {"rule",
           word,
           "",
           any,
           "",
           "INSIDE or blank: blocks that lie entirely inside the outline; CENTROID: "
           "blocks whose centroid is inside",
           {"INSIDE", "CENTROID"}}};
}
std::vector<FollowOn> selection_lines() {
  return {{"x1, x2, ..., xnc", "if nc is given: x of the corners of the outline [L], "
                               "over as many lines as needed"},
          {"y1, y2, ..., ync", "y of the corners [L], starting on a new line"}};
}

/// Adds the cards for boundaries and loads, A.2.7 to A.2.15.
void add_load_cards(std::vector<CardSpec>& cards) {
  using enum Kind;
  cards.push_back(
      {.name = "SPLANE",
       .section = "A.2.7",
       .summary = "a symmetry plane",
       .fields = {{"x1", real, {}, any, "[L]", "x of point 1"},
                  {"y1", real, {}, any, "[L]", "y of point 1"},
                  {"x2", real, {}, any, "[L]", "x of point 2"},
                  {"y2", real, {}, any, "[L]", "y of point 2"}},
       .notes = "An infinite frictionless line. The side on the left when looking "
                "from point 1 to point 2 is kept: all free blocks must lie there. "
                "A warning names those that are wholly or partly behind the "
                "plane. Several planes are allowed.",
       .example = "SPLANE, 0., 10., 0., 0."});
  cards.push_back({.name = "GRAVITY",
                   .section = "A.2.8",
                   .summary = "acceleration due to gravity",
                   .fields = {{"gravx", real, "0", any, "[L/T^2]", "in x"},
                              {"gravy", real, "0", any, "[L/T^2]", "in y"},
                              {"tramp", real, "0", not_negative, "[T]",
                               "time in which gravity changes to these values"}},
                   .notes = "The acceleration changes linearly in the time tramp after "
                            "the card, from the one before it. If tramp is 0, it "
                            "changes at once.",
                   .example = "GRAVITY, 0., -9.8"});
  cards.push_back({.name = "FIX",
                   .section = "A.2.9",
                   .summary = "fix a block",
                   .fields = {{"nblok",
                               block,
                               {},
                               from_one,
                               "[-]",
                               "block number, or selector of one or more blocks"}},
                   .notes = "The same as ifix on its CREATE card.",
                   .example = "FIX, 3"});
  cards.push_back(
      {.name = "REMOVE",
       .section = "ours",
       .summary = "remove blocks",
       .fields = selection_fields(),
       .follow_on = selection_lines(),
       .notes =
           "REMOVE, 12, 15 removes blocks 12 to 15; REMOVE, in(0, 0, 4, 3) those "
           "whose centroid is in the box; REMOVE, , , 2 removes all "
           "blocks of material 2. A block is inside the outline if it lies "
           "entirely within it at that moment; touching is allowed, and so is "
           "reaching beyond it by 1e-9 of the block. With CENTROID a block that "
           "crosses the outline goes if its centroid is inside or on it. The card acts "
           "at its place in the deck, so blocks can be removed in stages between "
           "MOTION cards. The numbers of the other blocks stay.",
       .example = "REMOVE, , , , 4\n39., 39., 43., 43.\n4., 5.5, 5.5, 4."});
  cards.push_back({.name = "FREE",
                   .section = "ours",
                   .summary = "free fixed blocks",
                   .fields = selection_fields(),
                   .follow_on = selection_lines(),
                   .notes = "Undoes FIX and ifix at its place in the deck. Blocks that "
                            "have left the domain or are removed stay as they are. The "
                            "blocks are named as in REMOVE.",
                   .example = "FREE, 3"});
  cards.push_back(
      {.name = "PRESSBC",
       .section = "A.2.10",
       .summary = "pressure on a side of a block",
       .fields = {{"nblok", block, "", from_one, "[-]",
                   "block number or selector; blank: all blocks, if nside is a "
                   "selector"},
                  {"nside",
                   side,
                   {},
                   from_one,
                   "[-]",
                   "side number, clockwise: side i runs from corner i to i + 1; or "
                   "selector of one or more sides"},
                  {"p1",
                   real,
                   {},
                   any,
                   "[F/L^2]",
                   "pressure at the first corner, times FUNCTION; positive pushes "
                   "inwards"},
                  {"p2", real, {}, any, "[F/L^2]", "pressure at the second corner"},
                  {"tarriv", real, "0", any, "[T]", "arrival time"}},
       .notes = "Needs a FUNCTION card. Nothing acts before the arrival time. On the "
                "sides of an edge or a line, the pressure is linear from p1 at its "
                "first point to p2 at its second; other sides have p1 and p2 at their "
                "own corners.",
       .example = "PRESSBC, 12, 2, 1.D6, 1.D6, .001"});
  cards.push_back({.name = "FORCE",
                   .section = "A.2.11",
                   .summary = "force at the centroid of a block",
                   .fields = {{"nblok",
                               block,
                               {},
                               from_one,
                               "[-]",
                               "block number, or selector of one block"},
                              {"fx", real, "0", any, "[F]", "in x, times FUNCTION"},
                              {"fy", real, "0", any, "[F]", "in y, times FUNCTION"},
                              {"tarriv", real, "0", any, "[T]", "arrival time"}},
                   .notes = "Needs a FUNCTION card. Several cards on a block add up.",
                   .example = "FORCE, 4, 0., -2.D5, 0."});
  cards.push_back(
      {.name = "FRICTN",
       .section = "A.2.12",
       .summary = "friction between blocks",
       .fields = {{"fric", real, "0", not_negative, "[-]", "coefficient of friction"}},
       .example = "FRICTN, .6"});
  cards.push_back(
      {.name = "SETVEL",
       .section = "A.2.13",
       .summary = "velocities of blocks by number",
       .fields = {{"nb1",
                   block,
                   {},
                   from_one,
                   "[-]",
                   "block number, or selector of one or more blocks"},
                  {"nb2", integer, "0", any, "[-]",
                   "0 or nb1: block nb1 alone; > nb1: nb1 to nb2; < 0: nb1 to the last "
                   "so far"},
                  {"vx", real, "0", any, "[L/T]", "velocity in x"},
                  {"vy", real, "0", any, "[L/T]", "velocity in y"},
                  {"tdot", real, "0", any, "[1/T]",
                   "spin, radians per time, anticlockwise positive"}},
       .notes = "Takes effect at its place in the deck; ignored for fixed blocks.",
       .example = "SETVEL, 2, 6, 0., 5., 0."});
  cards.push_back(
      {.name = "SETVELM",
       .section = "A.2.14",
       .summary = "velocities of all blocks of a material",
       .fields = {{"mat", integer, {}, from_one, "[-]", "material number"},
                  {"vx", real, "0", any, "[L/T]", "velocity in x"},
                  {"vy", real, "0", any, "[L/T]", "velocity in y"},
                  {"tdot", real, "0", any, "[1/T]",
                   "spin, radians per time, anticlockwise positive"}},
       .notes = "Useful for blocks from READ9, whose numbers are not known.",
       .example = "SETVELM, 1, 0., 3., 0."});
  cards.push_back({.name = "DAMPING",
                   .section = "A.2.15",
                   .summary = "contact damping",
                   .fields = {{"beta", real, "0", not_negative, "[-]",
                               "fraction of critical damping"}},
                   .example = "DAMPING, .2"});
}

/// Adds the cards for output and running, A.2.16 to A.2.21.
void add_run_cards(std::vector<CardSpec>& cards) {
  using enum Kind;
  cards.push_back(
      {.name = "DUMP",
       .section = "A.2.16",
       .summary = "print blocks, their states, boxes and contacts in full",
       .fields = {},
       .notes =
           "Has the quantities of the report's Appendix D under their names there. "
           "Useful for debugging; long for many blocks.",
       .example = "DUMP"});
  cards.push_back(
      {.name = "OUTPUT",
       .section = "A.2.17",
       .summary = "printed output at intervals of time",
       .fields = {{"dtout", real, {}, positive, "[T]", "interval"},
                  {"nb",
                   block,
                   "",
                   from_one,
                   "[-]",
                   "numbers or selectors of the blocks printed, any number of them; "
                   "none: all blocks",
                   {},
                   true}},
       .notes = "The card may continue on further lines. The state at the start and at "
                "the end is always printed. --set OUTPUT.nb=1,5 replaces all numbers.",
       .example = "OUTPUT, .1, 1, 5, 9",
       .continue_below = std::numeric_limits<std::size_t>::max()});
  cards.push_back(
      {.name = "PLOTS",
       .section = "A.2.18",
       .summary = "results for plotting at intervals of time",
       .fields = {{"dtplot", real, "", positive, "[T]",
                   "interval; blank: frames are counted in steps"},
                  {"t",
                   real,
                   "",
                   positive,
                   "[T]",
                   "further times with a frame, any number of them; without "
                   "dtplot the number of steps between frames (not in the "
                   "report)",
                   {},
                   true}},
       .notes = "A frame is the state after the step whose time is nearest. "
                "PLOTS, , n writes one every n steps from this card on, for runs "
                "whose time means nothing. The state at the start and at the end "
                "is always written. The card may continue on further lines.",
       .example = "PLOTS, .01, .0025, .0075",
       .continue_below = std::numeric_limits<std::size_t>::max()});
  cards.push_back(
      {.name = "HISTORY",
       .section = "ours",
       .summary = "histories of quantities at exact multiples of an interval",
       .fields = {{"dthist", real, {}, positive, "[T]", "interval"},
                  {"quantity",
                   word,
                   "",
                   any,
                   "",
                   "quantities, as 'blocks history -q' names them: ke, y:3, y:6-9, "
                   "y:material=2:p90, y:at(3, 4); none: ke, overlap, contacts",
                   {},
                   true}},
       .notes =
           "Samples are at the multiples of dthist, so those of several runs are "
           "at the same times. A value between two steps is interpolated linearly. "
           "Both steps are read, so an interval near the time step slows the run. "
           "The samples are in the results file, for 'blocks history'. Quantities "
           "energy:friction, energy:kinetic, ... are those of the energy account, "
           "which is kept if one of them is named (docs/laws.md). A later "
           "card replaces the earlier one from its place on. Blocks may be made "
           "after the card, except those of selectors: y:at(3, 4) is a block, "
           "y:in(0, 0, 9, 5) those in a box, y:nearest(3, 4) a corner. All quantities "
           "are on its line; "
           "--set HISTORY.quantity=ke,y:3 replaces all of them.",
       .example = "HISTORY, .001, ke, y:3, y:6-9"});
  cards.push_back({.name = "MOTION",
                   .section = "A.2.19",
                   .summary = "run for an interval of time",
                   .fields = {{"dt", real, {}, positive, "[T]", "interval"}},
                   .notes = "May repeat, with any cards between.",
                   .example = "MOTION, .5"});
  cards.push_back({.name = "CYCLE",
                   .section = "A.2.20",
                   .summary = "run for a number of time steps",
                   .fields = {{"ncycle", integer, {}, from_one, "[-]", "time steps"}},
                   .notes = "May repeat, with any cards between.",
                   .example = "CYCLE, 1000"});
  cards.push_back({.name = "STOP",
                   .section = "A.2.21",
                   .summary = "end of the run",
                   .fields = {},
                   .notes = "The end of the deck acts as STOP.",
                   .example = "STOP"});
}

}  // namespace

std::vector<CardSpec> problem_cards() {
  std::vector<CardSpec> cards = block_cards();
  for (CardSpec& card : joint_cards())
    cards.push_back(std::move(card));
  add_load_cards(cards);
  for (CardSpec& card : water_cards())
    cards.push_back(std::move(card));
  for (CardSpec& card : law_cards())
    cards.push_back(std::move(card));
  for (CardSpec& card : rest_cards())
    cards.push_back(std::move(card));
  for (CardSpec& card : crack_cards())
    cards.push_back(std::move(card));
  add_run_cards(cards);
  return cards;
}

}  // namespace blocks::deck
