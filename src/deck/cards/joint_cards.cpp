#include "deck/cards/joint_cards.hpp"

#include "deck/ranges.hpp"

namespace blocks::deck {
namespace {

constexpr Range joint_id{0, 1e9, false, false, false};
constexpr Range law_joint_id{1, 1e9, false, false, false};
// More corners, points or rounds are taken as typing errors.
constexpr Range outline_corners{3, 1e6, false, false, false};
constexpr Range points{1, 3e6, false, false, false};
constexpr Range rounds{0, 1000, false, false, false};

/// The mean and half range of a value of JSET.
FieldSpec mean(std::string_view name, std::string_view help) {
  return {name, Kind::exact, "0", not_negative, "[L]", help};
}
FieldSpec half_range(std::string_view name, std::string_view help) {
  return {name, Kind::exact, "0", not_negative, "[L]", help};
}

CardSpec joint_set() {
  using enum Kind;
  return {
      .name = "JSET",
      .section = "ours",
      .summary = "a joint set of the outline",
      .fields = {{"id", integer, "0", joint_id, "[-]",
                  "joint id of the sides that the set makes; 0: none"},
                 {"dip", exact, "0", any, "[degrees]",
                  "direction of the joints, anticlockwise from the x axis"},
                 {"ddev", exact, "0", not_negative, "[degrees]", "half range of dip"},
                 {"space",
                  exact,
                  {},
                  positive,
                  "[L]",
                  "mean spacing of the tracks, normal to them"},
                 half_range("sdev", "half range of space, < space; UNIFORM only"),
                 mean("trace", "mean length of the traces; 0: joints run through"),
                 half_range("tdev", "half range of trace, < trace"),
                 mean("gap", "mean gap between two traces of a track"),
                 half_range("gdev", "half range of gap, <= gap"),
                 {"x0", exact, "0", any, "[L]", "x of the start of track 0"},
                 {"y0", exact, "0", any, "[L]",
                  "y of the start; if both are blank and (0, 0) is far away: the "
                  "first corner of the outline"},
                 {"law",
                  word,
                  "UNIFORM",
                  any,
                  "",
                  "UNIFORM: spacing uniform in space +- sdev; NEGEXP: exponential; "
                  "POISSON: lines of all directions, 1/space length per area",
                  {"UNIFORM", "NEGEXP", "POISSON"}},
                 {"until", integer, "", law_joint_id, "[-]",
                  "joint id of cards above in the group: traces end where they meet "
                  "its joints; blank: nowhere"}},
      .notes =
          "Stands between OUTLINE and CUT. Track 0 begins at (x0, y0) with a trace; "
          "with until, a trace is followed from its middle to both sides. Further "
          "tracks follow on both sides, each with a random phase. Random "
          "values depend on the seed, on id and on the number of JSET cards with "
          "this id before it in the group, so a set continues across outlines, "
          "and no card changes the values of another.",
      .example = "JSET, 1, 35., 5., 4., .5, 12., 3., 1., .5",
      .continue_below = 13};
}

}  // namespace

std::vector<CardSpec> joint_cards() {
  using enum Kind;
  return {
      {.name = "OUTLINE",
       .section = "ours",
       .summary = "a domain to be cut into blocks by the joints that follow",
       .fields = {{"nc", integer, "", outline_corners, "[-]",
                   "number of corners, whose coordinates follow; blank if a file "
                   "gives them"},
                  {"mat", integer, {}, from_one, "[-]", "material of its blocks"},
                  {"file", word, "", any, "",
                   "a polygon from GeoJSON or WKT, or a closed line from DXF, "
                   "recognised by content"},
                  {"layer", word, "", any, "",
                   "the layer of the polygon, if the file has several polygons"}},
       .follow_on = {{"x1, x2, ..., xnc", "x of the corners [L], clockwise; over as "
                                          "many lines as needed"},
                     {"y1, y2, ..., ync", "y of the corners [L], starting on a new "
                                          "line"}},
       .notes =
           "Begins a group that ends with CUT. Only JSET, TRACES and VORONOI stand "
           "between them. A deck may have any number of groups. Give nc and the "
           "coordinates, or a file; its name is relative to the folder of the deck.",
       .example = "OUTLINE, 4, 1\n8., 8., 22., 22.\n2., 10., 10., 2."},
      joint_set(),
      {.name = "TRACES",
       .section = "ours",
       .summary = "mapped joint traces of the outline, from a file",
       .fields =
           {{"file",
             word,
             {},
             any,
             "",
             "GeoJSON, WKT, DXF or CSV with x1, y1, x2, y2, recognised by content"},
            {"id", integer, "0", joint_id, "[-]",
             "joint id of traces whose file gives none (property or column joint, "
             "number in the name of a DXF layer)"},
            {"snap", exact, "0", not_negative, "[L]",
             "a loose end is prolonged to the next joint or to the outline if "
             "that is at most this far"},
            {"layer", word, "", any, "",
             "only traces of this DXF layer, or with this property layer in GeoJSON; "
             "all of them then have id"}},
       .notes = "Stands between OUTLINE and CUT. A name is relative to the folder of "
                "the deck.",
       .example = "TRACES, mapped.geojson, 3, .5"},
      {.name = "VORONOI",
       .section = "ours",
       .summary = "Voronoi cells of the outline",
       .fields = {{"n", integer, "1", points, "[-]",
                   "number of random points, uniform in the outline"},
                  {"lloyd", integer, "0", rounds, "[-]",
                   "rounds of Lloyd's relaxation: more rounds make cells more even"},
                  {"id", integer, "0", joint_id, "[-]", "joint id of the cell sides"},
                  {"file", word, "", any, "",
                   "points from a file instead: GeoJSON, WKT or CSV with x, y"}},
       .notes = "Stands between OUTLINE and CUT. Give n or file.",
       .example = "VORONOI, 6, 2, 4"},
      {.name = "CUT",
       .section = "ours",
       .summary = "cut the outline into blocks",
       .fields = {{"emin", exact, "0", not_negative, "[L]",
                   "shorter edges are contracted; 0: none"},
                  {"amin", exact, "0", not_negative, "[L^2]",
                   "smaller cells are merged into a neighbour; 0: none"},
                  {"id",
                   integer,
                   "",
                   law_joint_id,
                   "[-]",
                   "joint ids whose corners are not moved and whose sides are not "
                   "merged away, any number of them",
                   {},
                   true}},
       .notes = "Ends the group that OUTLINE begins. The cells are certified: they "
                "fill the outline without overlap or gap. Joints that separate no two "
                "blocks are removed and reported.",
       .example = "CUT, .8, 1.5"}};
}

}  // namespace blocks::deck
