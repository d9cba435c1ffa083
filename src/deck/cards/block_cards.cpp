#include "deck/cards/block_cards.hpp"

#include "deck/ranges.hpp"

namespace blocks::deck {
namespace {

constexpr Range face_ids{0, 1e9, false, false, false};
constexpr Range angle{-80, 80, false, false, false};
// A layer of more than a million blocks is taken as a typing error. The limit matters
// because short lists of widths are completed in memory.
constexpr Range layer_count{-1e6, 1e6, false, false, true};

/// A field with the joint id of some faces.
FieldSpec face_id(std::string_view name, std::string_view help) {
  return {name, Kind::integer, "0", face_ids, "[-]", help};
}

}  // namespace

std::vector<CardSpec> block_cards() {
  using enum Kind;
  std::vector<CardSpec> cards;
  cards.push_back(
      {.name = "CREATE",
       .section = "A.2.1",
       .summary = "one block from its corners",
       .fields = {{"nc",
                   integer,
                   {},
                   {3, infinity, false, false, false},
                   "[-]",
                   "number of corners, at most ncmx of START"},
                  {"mat", integer, {}, from_one, "[-]", "material number"},
                  {"ifix", integer, "0", any, "[-]", "not 0: the block is fixed"}},
       .follow_on = {{"x1, x2, ..., xnc", "x of the corners [L], clockwise; over as "
                                          "many lines as needed"},
                     {"y1, y2, ..., ync", "y of the corners [L], starting on a new "
                                          "line"}},
       .notes = "Anticlockwise corners are accepted with a warning: corner 1 is kept "
                "and the rest reversed.",
       .example = "CREATE, 4, 1, 1\n0., 0., 60., 60.\n-2., 0., 0., -2."});
  cards.push_back(
      {.name = "CLOOP",
       .section = "A.2.2",
       .summary = "repeat the next CREATE with a shift",
       .fields = {{"nloop", integer, {}, from_one, "[-]", "number of blocks in total"},
                  {"radd", exact, "0", any, "[L]", "shift in x from copy to copy"},
                  {"zadd", exact, "0", any, "[L]", "shift in y from copy to copy"}},
       .notes = "Must come directly before its CREATE. Copy k is shifted by (k - 1) "
                "(radd, zadd).",
       .example = "CLOOP, 5, 0., 1.\nCREATE, 4, 1\n40., 40., 42., 42.\n0., 1., 1., "
                  "0."});
  cards.push_back(
      {.name = "READ9",
       .section = "A.2.3",
       .summary = "blocks from a mesh file",
       .fields =
           {{"file", word, "tape9", any, "",
             "mesh file (not in the report): text, Gmsh .msh, "
             "GENESIS or region records, recognised by content"},
            face_id("jbot",
                    "joint id of bottom faces that have none in the file; 0: none"),
            face_id("jtop",
                    "joint id of top faces that have none in the file; 0: none"),
            face_id("jside",
                    "joint id of other faces that have none in the file; 0: none")},
       .notes = "Quote a file name that contains blanks or commas. A face "
                "is a top or a bottom if its outward normal is within 45 "
                "degrees of the y axis.",
       .example = "READ9, mine.msh"});
  cards.push_back(
      {.name = "LAYER",
       .section = "A.2.4",
       .summary = "a layer of blocks between two lines",
       .fields =
           {{"ns",
             integer,
             {},
             layer_count,
             "[-]",
             "number of blocks; > 0: two lists of widths follow, < 0: even or "
             "random widths"},
            {"mat", integer, {}, from_one, "[-]", "material number"},
            {"x1", exact, {}, any, "[L]", "x of corner 1, bottom left"},
            {"y1", exact, {}, any, "[L]", "y of corner 1"},
            {"x2", exact, {}, any, "[L]", "x of corner 2, top left"},
            {"y2", exact, {}, any, "[L]", "y of corner 2"},
            {"x3", exact, {}, any, "[L]", "x of corner 3, top right"},
            {"y3", exact, {}, any, "[L]", "y of corner 3"},
            {"x4", exact, {}, any, "[L]", "x of corner 4, bottom right"},
            {"y4", exact, {}, any, "[L]", "y of corner 4"},
            {"rcommand",
             word,
             "",
             any,
             "",
             "RANDOM with ns < 0: random widths along the mid-line, each block "
             "0.2 to 3 times as wide as high",
             {"RANDOM"}},
            face_id("jbot", "joint id of the bottom faces of its blocks; 0: none"),
            face_id("jtop", "joint id of the top faces; 0: none"),
            face_id(
                "jside",
                "joint id of the faces between its blocks and at its ends; 0: none")},
       .follow_on = {{"sb1, sb2, ..., sbns",
                      "ns > 0 only: widths along the bottom line "
                      "[L], > 0, from the left"},
                     {"st1, st2, ..., stns", "ns > 0 only: widths along the top line "
                                             "[L], starting on a new line"}},
       .notes = "The card may continue on the next line before its eighth coordinate. "
                "A list of one or two widths repeats its last one. Widths that do not "
                "add up to the length of the line are scaled, with a message.",
       .example = "LAYER, -12, 1, 0., 0., 0., 2., 30., 2., 30., 0., RANDOM",
       .continue_below = 10});
  cards.push_back(
      {.name = "ORIENT",
       .section = "A.2.5",
       .summary = "inclination of the block sides of later RANDOM layers",
       .fields = {{"angmin", exact, "0", angle, "[degrees]", "least angle"},
                  {"angplus", exact, "0", angle, "[degrees]",
                   "greatest angle, >= angmin; both the same: all sides parallel"}},
       .notes = "From the normal of the mid-line, anticlockwise positive. Each side "
                "draws its own angle.",
       .example = "ORIENT, -10., 10."});
  cards.push_back({.name = "MERGE",
                   .section = "A.2.6",
                   .summary = "absorb slender blocks of later RANDOM layers",
                   .fields = {{"aratio",
                               exact,
                               {},
                               not_negative,
                               "[-]",
                               "least width over height that is kept"}},
                   .notes = "A slender block is absorbed by the next one on the right, "
                            "the last one by its left neighbour.",
                   .example = "MERGE, .5"});
  return cards;
}

}  // namespace blocks::deck
