#include "audit/words.hpp"

#include <fmt/format.h>

namespace blocks::audit {

int number_in_block(const Blocks& blocks, int corner) {
  return corner - blocks.first_corner[blocks.corner_block[corner]] + 1;
}

std::string name_of(const Blocks& blocks, int corner) {
  return fmt::format("corner {} of block {}", number_in_block(blocks, corner),
                     blocks.corner_block[corner] + 1);
}

std::string name_of_edge(const Blocks& blocks, int edge) {
  return fmt::format("edge {} of block {}", number_in_block(blocks, edge),
                     blocks.corner_block[edge] + 1);
}

std::string contacts_in_words(const Blocks& blocks,
                              const std::vector<std::pair<int, int>>& contacts) {
  std::string text;
  for (const auto& [corner, edge] : contacts)
    text += fmt::format("{}{} on {}", text.empty() ? "" : "; ", name_of(blocks, corner),
                        name_of_edge(blocks, edge));
  return text.empty() ? "no contact" : text;
}

std::vector<std::string> in_lines(const std::string& text, std::size_t indent,
                                  std::size_t columns) {
  std::vector<std::string> lines;
  std::string line(indent, ' ');
  std::size_t at = 0;
  while (line.size() + text.size() - at > columns) {
    const std::size_t space = text.rfind(' ', at + columns - line.size());
    if (space == std::string::npos || space <= at)
      break;  // a word that is longer than a line
    lines.push_back(line + text.substr(at, space - at));
    line.assign(indent + 2, ' ');
    at = space + 1;
  }
  lines.push_back(line + text.substr(at));
  return lines;
}

std::string tell(const BlockPair& missed) {
  return fmt::format("the list of near pairs misses blocks {} and {}", missed.first + 1,
                     missed.second + 1);
}

std::string tell(const Blocks& blocks, const WrongPair& wrong) {
  return fmt::format(
      "wrong decision about blocks {} and {}: the run has {}; exact is {}",
      wrong.first + 1, wrong.second + 1, contacts_in_words(blocks, wrong.acting),
      contacts_in_words(blocks, wrong.exact));
}

std::string tell(const Blocks& blocks, const PlaneFault& fault) {
  return fmt::format("{} is {} symmetry plane {}, but {}",
                     name_of(blocks, fault.corner),
                     fault.acts ? "not behind" : "behind", fault.plane + 1,
                     fault.acts ? "acts on it" : "does not act on it");
}

std::string tell(const ExcessOverlap& excess) {
  return fmt::format("blocks {} and {} overlap by {:.6g} near ({:.6g}, {:.6g}), but "
                     "their deepest contact is only {:.6g} deep (springs compressed by "
                     "{:.6g}): {:.6g} more than the contacts explain",
                     excess.first + 1, excess.second + 1, excess.depth,
                     excess.place.x(), excess.place.y(), excess.explained,
                     excess.pressed, excess.excess());
}

std::string tell(const Blocks& blocks, const DeepContact& deep) {
  const Vec2 at = blocks.corner.col(deep.corner);
  return fmt::format(
      "{} at ({:.9g}, {:.9g}) acts {:.6g} deep on {} (spring compressed by {:.6g}), "
      "but the two blocks overlap by only {:.6g} along its normal",
      name_of(blocks, deep.corner), at.x(), at.y(), deep.overlap,
      name_of_edge(blocks, deep.edge), deep.pressed, deep.common);
}

}  // namespace blocks::audit
