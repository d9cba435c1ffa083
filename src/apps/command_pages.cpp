#include "command_pages.hpp"

namespace blocks::apps {
namespace {

constexpr std::size_t page_width = 79;

/// Words in lines of at most page_width.
std::string wrapped(const std::string& text) {
  std::string out;
  std::size_t column = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    if (column > 0 && column + 1 + to - from > page_width) {
      out += '\n';
      column = 0;
    } else if (column > 0) {
      out += ' ';
      ++column;
    }
    out += text.substr(from, to - from);
    column += to - from;
    from = to + 1;
  }
  return out;
}

}  // namespace

const std::map<std::string, CommandPage>& command_pages() {
  const std::string run_stack = "blocks run decks/stack/stack.deck";
  static const std::map<std::string, CommandPage> pages = {
      {"run",
       {"blocks run decks/stack/stack.deck -o stack", "",
        "Runs a deck and writes NAME.out (listing), NAME.vtkhdf (results), "
        "NAME.ckpt.h5 (checkpoint) and NAME.summary.json."}},
      {"why",
       {"blocks why stack.vtkhdf --block 2 --block 3", run_stack,
        "Tells which corners of two blocks act on which edges: the axes in the order "
        "of the choice, which of them are entered or hidden by closed joints, and the "
        "contacts along the chosen one. Everything is decided exactly. Given one "
        "block, it lists the blocks near it."}},
      {"check",
       {"blocks check decks/stack/stack.deck", "",
        "Reports every error of a deck in one pass and proves its layers. With "
        "--geometry: shapes, overlaps, gaps and joints of the blocks; exit code 3 when "
        "blocks overlap."}},
      {"cards", {"blocks cards LAYER", "", "Lists all cards, or describes one."}},
      {"plot",
       {"blocks plot stack.vtkhdf --forces -o stack.png", run_stack,
        "Draws the blocks, coloured by material or a quantity, with contact forces or "
        "arrows: at one time, at several on one sheet (-t 0,1,2), or as a movie "
        "(-o stack.mp4)."}},
      {"history",
       {"blocks history stack.vtkhdf -q y:4,speed:max -o stack.png", run_stack,
        "Follows quantities of blocks, corners and the model in time: a table, CSV, "
        "JSON, a figure. Several runs are laid over each other. With --profile: across "
        "the model at some times, such as a subsidence trough."}},
      {"view",
       {"blocks view stack.vtkhdf -o stack.html", run_stack,
        "Writes one page for the browser, which needs no server and no network: play, "
        "zoom, pick a block, see its numbers and their history."}},
      {"import",
       {"blocks import decks/every_card/hexagons.txt --deck", "",
        "Reads outlines from GeoJSON, WKT, Gmsh .msh or another form of READ9, checks "
        "them exactly, and writes a mesh for READ9 and, with --deck, a deck around "
        "it."}},
      {"export",
       {"blocks export decks/stack/stack.deck -o stack.geojson", "",
        "Writes the blocks of a deck, or of results at one time, as GeoJSON, WKT, Gmsh "
        ".msh or READ9's text form; every coordinate reads back bit for bit. Of "
        "results "
        "at all times, blocks and contacts: .pvd for ParaView and VisIt, .csv."}},
      {"study",
       {"blocks study contacts figure4b --variants default,report", "",
        "Runs variants of the contact rules side by side, in random frames; see "
        "docs/robustness.md."}},
      {"manual",
       {"blocks manual deck -o blocks-deck.5", "",
        "Prints the man page blocks(1) (program), the man page blocks-deck(5) (deck), "
        "or the completion for bash (bash); `man -l FILE` shows a page."}}};
  return pages;
}

std::string help_head(const CommandPage& page) {
  return "Example: " + page.example + "\n" +
         (page.beforehand.empty() ? "" : "(after " + page.beforehand + ")\n") + "\n" +
         wrapped(page.description);
}

}  // namespace blocks::apps
