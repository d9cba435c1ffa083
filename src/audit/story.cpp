#include "audit/story.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "audit/words.hpp"

namespace blocks::audit {
namespace {

/// Names the block of a part, and also the part if the block has several.
std::string name_of_part(const ExactPairRule& rule, int part) {
  const std::vector<ConvexPart>& parts = rule.parts();
  const auto of_block = [&](int p) {
    return p >= 0 && p < static_cast<int>(parts.size()) &&
           parts[p].block == parts[part].block;
  };
  int first = part;
  while (of_block(first - 1))
    --first;
  const std::string block = fmt::format("block {}", parts[part].block + 1);
  return of_block(first + 1) ? fmt::format("part {} of {}", part - first + 1, block)
                             : block;
}

std::string words(const FarBound& far) {
  const char* what = "";
  switch (far.bound) {
  case Bound::separating_shift:
    what = "the shortest shift that separates the two";
    break;
  case Bound::common_diameter:
    what = "the diameter of what the two have in common";
    break;
  case Bound::third_part:
    what = "the shift that separates a third part from one of them";
    break;
  }
  return fmt::format("far: deeper than {:.6g}, twice {}", far.twice, what);
}

/// Says what a third part does where it blocks the shift out of the axis.
std::string words(const ExactPairRule& rule, const Axis& axis, const Blocking& third) {
  const bool own = third.whose == ThirdOf::own;
  const int continued = own ? axis.side.part : axis.deepest.part,
            shifted = own ? axis.deepest.part : axis.side.part;
  return fmt::format(
      "{} by {}, a third part of {}: shifted out, {} overlaps it by "
      "{:.6g}; a slide of {:.6g} ends that, with {:.6g} of the side left, or one of "
      "{:.6g}, with {:.6g}",
      third.hides ? "hidden" : "not hidden", name_of_part(rule, third.part),
      name_of_part(rule, continued), name_of_part(rule, shifted), third.overlap,
      third.shorter.length, std::max(third.shorter.rest, 0.0), third.longer.length,
      std::max(third.longer.rest, 0.0));
}

/// The lines of a story.
struct Lines {
  std::vector<std::string> all;
  void add(std::size_t indent, const std::string& text) {
    for (std::string& line : in_lines(text, indent, story_columns))
      all.push_back(std::move(line));
  }
};

void add_axes(const ExactPairRule& rule, const PartDecision& decision, Lines& lines) {
  const Blocks& blocks = rule.blocks();
  int rest = 0;
  for (int i = 0; i < static_cast<int>(decision.axes.size()); ++i) {
    const Axis& axis = decision.axes[i];
    if (!axis.examined && i != decision.chosen) {
      ++rest;
      continue;
    }
    lines.add(0, fmt::format("axis of {}: {} is {:.6g} deep, {}",
                             name_of(blocks, axis.side), name_of(blocks, axis.corner),
                             axis.depth,
                             axis.facing ? "facing " + name_of(blocks, *axis.facing)
                                         : "no facing side"));
    for (const std::string& sentence : verdict(rule, decision, i))
      lines.add(2, sentence);
  }
  if (decision.choice == Choice::none)
    lines.add(0,
              fmt::format("{}: nothing acts, because {}, which hides the least axis, "
                          "carries one of the two",
                          decision.chosen < 0 ? "no axis is left"
                                              : "the least axis is within the slack",
                          name_of_part(rule, decision.carrier)));
  else if (decision.choice == Choice::least_axis)
    lines.add(0, "no axis is left, and no third part carries: the least axis "
                 "acts");
  else if (rest > 0)
    lines.add(0, fmt::format("{} deeper axes are not needed", rest));
}

}  // namespace

std::string name_of(const Blocks& blocks, const PartSide& side) {
  if (!side.inner)
    return name_of_edge(blocks, side.start);
  return fmt::format("the inner side from corner {} to corner {} of block {}",
                     number_in_block(blocks, side.start),
                     number_in_block(blocks, side.end),
                     blocks.corner_block[side.start] + 1);
}

std::vector<std::string> verdict(const ExactPairRule& rule,
                                 const PartDecision& decision, int index) {
  const Axis& axis = decision.axes[index];
  if (!axis.examined)
    return {decision.choice == Choice::touching && index == decision.chosen
                ? "not deeper than zero, so the side separates the two: acts"
                : "not needed"};
  if (axis.skipped)
    return {"skipped: it is an inner side"};
  if (axis.far)
    return {words(*axis.far)};
  std::vector<std::string> found;
  for (const Blocking& third : axis.blocking)
    if (third.hides == axis.hidden())
      found.push_back(words(rule, axis, third));
  if (!axis.hidden() && decision.choice == Choice::none)
    found.push_back("would act");
  else if (!axis.hidden())
    found.push_back(std::any_of(decision.candidates.begin(), decision.candidates.end(),
                                [](const Candidate& one) { return one.acts; })
                        ? "acts"
                        : "acts, but no contact along it does");
  return found;
}

std::string verdict(const ExactPairRule& rule, const Candidate& candidate) {
  if (!candidate.inside)
    return "outside";
  if (candidate.side.inner)
    return "on an inner side";
  if (!candidate.between && !candidate.no_end)
    return "foot beyond the end";
  if (candidate.far)
    return "far";
  if (!candidate.no_end)
    return "acts";
  return fmt::format("acts: foot beyond the end, {} {}",
                     *candidate.no_end == NoEnd::notch ? "in a notch with"
                                                       : "at the joint with",
                     name_of_part(rule, candidate.third));
}

std::vector<std::string> story(const ExactPairRule& rule, int a, int b,
                               const PairDecision& decision) {
  const Blocks& blocks = rule.blocks();
  Lines lines;
  lines.add(0, fmt::format("blocks {} and {}: {}", a + 1, b + 1,
                           contacts_in_words(blocks, decision.contacts)));
  for (const PartDecision& part : decision.parts) {
    const std::string pair = fmt::format("{} and {}", name_of_part(rule, part.part),
                                         name_of_part(rule, part.other));
    if (part.choice == Choice::apart) {
      lines.add(0, fmt::format("{} are apart by {:.6g} beyond {}", pair,
                               -part.separation, name_of(blocks, part.separating)));
      continue;
    }
    if (decision.parts.size() > 1)
      lines.add(0, pair + ":");
    add_axes(rule, part, lines);
    for (const Candidate& candidate : part.candidates)
      lines.add(0, fmt::format("{} on {}: {:.6g} deep: {}",
                               name_of(blocks, candidate.corner),
                               name_of(blocks, candidate.side), candidate.depth,
                               verdict(rule, candidate)));
  }
  return lines.all;
}

}  // namespace blocks::audit
