#include "rock.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "run/run.hpp"

namespace blocks::bench {
namespace {

constexpr int piece = 4;  // [L] width of a block of the floor and of the walls

/// The cards of the fixed blocks around the rock, and their number.
class Frame {
 public:
  void add(int left, int bottom) {
    cards_ += fmt::format("CREATE, 4, 1, 1\n{0}, {0}, {1}, {1}\n{2}, {3}, {3}, {2}\n",
                          left, left + piece, bottom, bottom + piece);
    ++count_;
  }
  const std::string& cards() const { return cards_; }
  int count() const { return count_; }

 private:
  std::string cards_;
  int count_ = 0;
};

/// Returns a multiple of the size of a fixed block.
int rounded(double length) {
  return piece * std::max(1, static_cast<int>(std::lround(length / piece)));
}

std::string deck_of(Cut cut, int blocks, Support support, bool laws) {
  const int width = rounded(std::sqrt(1.5 * blocks)), height = rounded(width / 1.5);
  const int runout = support == Support::one_wall ? height : 0;
  Frame frame;
  for (int x = 0; x < width + runout; x += piece)
    frame.add(x, -piece);
  for (int y = 0; y < height; y += piece)
    frame.add(-piece, y);
  const int right_wall = frame.count() + 1;
  for (int y = 0; y < height && support != Support::one_wall; y += piece)
    frame.add(width, y);
  std::string deck = fmt::format(
      "START, {}, 32\nCUT ROCK\nXLIMITS, {}., {}.\nYLIMITS, {}., {}.\n"
      "BOXES, {}, {}, .01\nSTIFF, 1.E9, 5.E8\nFRACTION, .04\n"
      "MATERIAL, 1, 2.E10, 8.E9, 2600.\nRIGID\nSEED, 7\nEND\n",
      2 * blocks + frame.count() + 100, -2 * piece, width + runout + 2 * piece,
      -2 * piece, height + 2 * piece, width, height);
  deck += frame.cards();
  deck += fmt::format("OUTLINE, 4, 1\n0., 0., {0}., {0}.\n0., {1}., {1}., 0.\n", width,
                      height);
  deck += cut == Cut::two_sets ? "JSET, 1, 60., 3., 1., .3\nJSET, 2, 150., 3., 1., .3\n"
                               : fmt::format("VORONOI, {}, 1, 2\n", width * height);
  deck += "CUT, .1, .05\nGRAVITY, 0., -9.81\nFRICTN, .6\nDAMPING, .3\n";
  for (const int id : {1, 2})
    if (laws)
      deck += fmt::format("JOINT, {}, .6, , , , , , , , 1.E9, 5.E8\n", id);
  if (support != Support::one_wall)
    deck += "LOCDAMP, .7\n";
  if (support == Support::receding_wall)
    for (int b = right_wall; b <= frame.count(); ++b)
      deck += fmt::format("DRIVE, {}, .02\n", b);
  return deck + "CYCLE, 1\nSTOP\n";
}

}  // namespace

Model cut_rock(Cut cut, int blocks, Support support, bool laws) {
  run::RunOptions options;
  options.deck = "cut rock";
  options.text = deck_of(cut, blocks, support, laws);
  options.quiet = true;
  options.tell = [](const deck::Diagnostics&) {};
  run::CheckedDeck checked = run::build_checked(options);
  if (checked.code != run::done)
    throw std::runtime_error("cut rock: the deck has faults");
  return std::move(checked.model);
}

}  // namespace blocks::bench
