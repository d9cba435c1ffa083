#include "command_pages.hpp"

namespace blocks::apps {

const std::map<std::string, CommandPage>& command_pages() {
  const std::string run_stack = "blocks run decks/stack/stack.deck";
  static const std::map<std::string, CommandPage> pages = {
      {"run",
       {"blocks run decks/stack/stack.deck -o stack", "",
        "Runs a deck and writes NAME.out (listing), NAME.vtkhdf (results), "
        "NAME.ckpt.h5 (checkpoint) and NAME.summary.json."}},
      {"fos",
       {"blocks fos decks/cut_slope/cut_slope.deck -o slope", "",
        "Runs a deck that ends in equilibrium, and finds the factor of safety by "
        "reduction of strength, as a FOS card behind its last card does. Writes the "
        "files of a run, and those of the last stable and the first failing trial as "
        "NAME.stable and NAME.failing."}},
      {"why",
       {"blocks why stack.vtkhdf --block 2 --block 3", run_stack,
        "Shows which corners of two blocks act on which edges: the axes in the order "
        "in which they are tested, which of them are far or hidden by closed "
        "joints, and the contacts along the chosen axis. Every decision is exact. With "
        "one block, it lists the blocks near it."}},
      {"check",
       {"blocks check decks/stack/stack.deck", "",
        "Reports every error of a deck in one pass and proves that layers have no gaps "
        "or overlaps. With --geometry, it also reports shapes, overlaps, gaps and "
        "joints of the blocks; the exit code is 3 if blocks overlap."}},
      {"cards",
       {"blocks cards LAYER", "",
        "Lists all cards, or describes one. With --set, it lists the fields of a deck "
        "that the option --set of run and check can replace."}},
      {"plot",
       {"blocks plot stack.vtkhdf --forces -o stack.png", run_stack,
        "Draws the blocks, coloured by material, joint or a quantity, with contact "
        "forces or arrows. It draws one time, several times on one sheet (-t 0,1,2), "
        "or "
        "a movie (-o stack.mp4). With --joints, it draws a rose of joint directions "
        "and "
        "histograms of the blocks."}},
      {"history",
       {"blocks history stack.vtkhdf -q y:4,speed:max -o stack.png", run_stack,
        "Writes quantities of blocks, corners and the model over time as a table, CSV, "
        "JSON or a figure. Several runs share one figure. With --profile, it writes "
        "quantities across the model at given times, such as a subsidence trough."}},
      {"cracks",
       {"blocks cracks stack.vtkhdf", run_stack,
        "Lists the blocks that have split under a CRACK card: when, why, in which "
        "direction, and into which pieces. With -o, it writes all values as CSV or "
        "JSON, or draws a rose of the directions. Their number in time is the quantity "
        "cracks of blocks history."}},
      {"view",
       {"blocks view stack.vtkhdf -o stack.html", run_stack,
        "Writes one page for the browser, which needs no server and no network. It "
        "plays the run, shows numbers and histories of one or two blocks and the "
        "joints "
        "of their sides, and saves pictures and CSV. The key ? lists its keys."}},
      {"report",
       {"blocks report stacks -q displacement:max",
        "blocks sweep decks/stack/stack.deck --seeds 1-4 -o stacks",
        "Writes the statistics of a sweep as one page that opens without a server: "
        "outcomes, a typical run, the profile as median and band, histograms, means "
        "with intervals, the effect of a parameter, and a link to every run. The table "
        "is also printed, and written as CSV or JSON."}},
      {"import",
       {"blocks import decks/every_card/hexagons.txt --deck", "",
        "Reads outlines from GeoJSON, WKT, Gmsh .msh or another form that READ9 reads, "
        "checks them exactly, and writes a mesh for READ9. With --deck, it also writes "
        "a deck that uses the mesh."}},
      {"export",
       {"blocks export decks/stack/stack.deck -o stack.geojson", "",
        "Writes the blocks of a deck, or of results at one time, as GeoJSON, WKT, Gmsh "
        ".msh or READ9's text form; coordinates are written exactly. From results, it "
        "also writes blocks and contacts at all times: .pvd for ParaView and VisIt, or "
        ".csv."}},
      {"joints",
       {"blocks joints statistics decks/slope/slope.deck", "",
        "Measures mapped fracture traces, and the joints of a deck before they are "
        "cut: "
        "nodes and branches, density and length corrected for the window, families of "
        "directions, spacing along scanlines. Several inputs are columns of one table, "
        "so that a generated network can be compared with its map; see "
        "docs/joint-statistics.md."}},
      {"fit",
       {"blocks joints fit decks/slope/slope.deck -o model.deck", "",
        "Finds the families of directions of a map of traces, and writes a deck with a "
        "joint set for each of them; see docs/joint-statistics.md."}},
      {"study",
       {"blocks study contacts figure4b --variants default,report", "",
        "Runs variants of the contact rules on the same random copies of a scene and "
        "compares them; see docs/robustness.md."}},
      {"sweep",
       {"blocks sweep decks/stack/stack.deck --set FRICTN.fric=.3,.5 -o many", "",
        "Runs a deck many times, with many seeds or values of its fields, and keeps "
        "everything in one folder. The same command, or the name of the folder, goes "
        "on "
        "with what is missing."}},
      {"manual",
       {"blocks manual deck -o blocks-deck.5", "",
        "Prints the man page blocks(1) (program), the man page blocks-deck(5) (deck), "
        "or the completion for bash (bash); `man -l FILE` shows a page."}}};
  return pages;
}

}  // namespace blocks::apps
