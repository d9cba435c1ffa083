#include "audit/words.hpp"

#include <fmt/format.h>

#include <limits>

namespace blocks::audit {
namespace {

int number(const Blocks& blocks, int corner) {
  return corner - blocks.first_corner[blocks.corner_block[corner]] + 1;
}

std::string headline(const ExactRules& rules, const Decision& decision) {
  const Blocks& blocks = rules.blocks();
  const Vec2 at = blocks.corner.col(decision.corner);
  std::string text = fmt::format(
      "{} at ({:.9g}, {:.9g}) against block {}: ", name_of(blocks, decision.corner),
      at.x(), at.y(), decision.block + 1);
  if (decision.notch >= 0)
    return text + fmt::format("edges {} and {} act", number(blocks, decision.acting),
                              number(blocks, decision.notch));
  if (decision.acting >= 0)
    return text + fmt::format("edge {} acts", number(blocks, decision.acting));
  return text + "no contact";
}

/// The edge that a corner outside a convex block is farthest out of.
std::string outside(const ExactRules& rules, int corner, int block) {
  const Blocks& blocks = rules.blocks();
  double least = std::numeric_limits<double>::infinity();
  int edge = -1;
  for (int e = blocks.first_corner[block]; e < blocks.first_corner[block + 1]; ++e)
    if (const double d = rules.overlap(corner, e); d < least)
      least = d, edge = e;
  return fmt::format("it is outside block {}: {:.6g} beyond the line of edge {}",
                     block + 1, -least, number(blocks, edge));
}

std::string what(const Blocks& blocks, const Decision& decision, int edge) {
  return edge < 0 ? "no contact"
                  : fmt::format("edge {} of block {}", number(blocks, edge),
                                decision.block + 1);
}

std::string joint_words(const Blocks& blocks, const Shield& shield,
                        const std::string& whom) {
  return fmt::format(
      "{} (a closed joint: the surface goes on in block {}; {} is {:.6g} "
      "below it, at most {:.6g})",
      whom, shield.third + 1, name_of(blocks, shield.corner), shield.depth,
      shield.reach);
}

/// What closed joints hide here; empty: nothing that matters.
std::string on_joints(const ExactRules& rules, const Decision& decision) {
  const Blocks& blocks = rules.blocks();
  if (decision.possible.size() > 1) {
    std::string which;
    for (const int edge : decision.possible)
      which += (which.empty() ? "" : " or ") + what(blocks, decision, edge);
    return "joint: hangs by the rounding of doubles: " + which +
           ", one as right as the "
           "other";
  }
  const std::string then = decision.acting < 0
                               ? "no edge acts"
                               : fmt::format("the next nearest, edge {}, "
                                             "acts",
                                             number(blocks, decision.acting));
  const int nearest = number(blocks, decision.nearest);
  if (decision.side.answer == Answer::yes)
    return joint_words(
               blocks, decision.side,
               fmt::format("joint: edge {} is hidden from the corner", nearest)) +
           "; " + then;
  if (decision.hidden.answer == Answer::yes)
    return joint_words(
               blocks, decision.hidden,
               fmt::format("joint: the corner is hidden from edge {}", nearest)) +
           "; " + then;
  return decision.next < 0
             ? ""
             : fmt::format("joint: none hides edge {} here, so the nearest edge counts",
                           nearest);
}

std::string numbers(const Blocks& blocks, const EdgeStory& edge) {
  std::string text =
      fmt::format("overlap {:.6g} of at most {:.6g}", edge.overlap, edge.depth_limit);
  if (!blocks.convex[blocks.corner_block[edge.edge]])
    text += fmt::format(", at {:.6g} of the edge", edge.along);
  return text + fmt::format(", tangents {:.6g} and {:.6g}", edge.tangent_before,
                            edge.tangent_after);
}

std::string faces_away(const ExactRules& rules, int corner, const EdgeStory& edge) {
  const Blocks& blocks = rules.blocks();
  const auto side = [&](int neighbour) {
    return fmt::format("its side to corner {} points into the block (below -0.173648)",
                       number(blocks, neighbour));
  };
  if (!edge.facing_before && !edge.facing_after)
    return "both its sides point into the block (below -0.173648)";
  return side(edge.facing_before ? blocks.next[corner] : blocks.previous[corner]);
}

}  // namespace

std::string name_of(const Blocks& blocks, int corner) {
  return fmt::format("corner {} of block {}", number(blocks, corner),
                     blocks.corner_block[corner] + 1);
}

std::string verdict(const ExactRules& rules, const Decision& decision,
                    const EdgeStory& edge) {
  const Blocks& blocks = rules.blocks();
  if (edge.edge == decision.notch)
    return "the other edge of the notch, acts";
  if (edge.edge == decision.acting && decision.crossing)
    return "a side of the corner's block crosses the next edge, acts";
  if (edge.edge == decision.acting)
    return edge.edge == decision.nearest ? "nearest of those admitted, acts"
                                         : "next nearest, acts";
  if (!decision.inside)
    return edge.edge == decision.nearest ? "nearest, but no overlap"
                                         : "refused: the corner is outside the block";
  if (!blocks.convex[decision.block]) {
    if (!edge.near_or_inside)
      return "refused: the corner is outside of it";
    if (!edge.between)
      return "refused: the corner is not between its ends (slack 1e-6)";
  }
  if (!edge.within_depth)
    return blocks.convex[decision.block]
               ? "refused: deeper than the centroid of the block"
               : "refused: deeper than half of the block's deepest corner";
  if (!edge.facing_before || !edge.facing_after)
    return "refused: " + faces_away(rules, decision.corner, edge);
  if (!edge.comes_through)
    return fmt::format("refused: not the nearest, and block {} does not reach it",
                       blocks.corner_block[decision.corner] + 1);
  if (edge.edge == decision.nearest)
    return edge.overlap_sign > 0 ? "nearest, but hidden by a joint"
                                 : "nearest, but no overlap";
  if (rules.overlap(decision.corner, decision.nearest) > edge.overlap)
    return fmt::format("admitted, but block {} does not reach it, and edge {} it does",
                       blocks.corner_block[decision.corner] + 1,
                       number(blocks, decision.nearest));
  return fmt::format("admitted, but edge {} is nearer",
                     number(blocks, decision.nearest));
}

std::vector<std::string> story(const ExactRules& rules, const Decision& decision) {
  const Blocks& blocks = rules.blocks();
  const int c = decision.corner, b = decision.block;
  std::vector<std::string> lines = {headline(rules, decision)};
  if (!decision.inside) {
    lines.push_back(blocks.convex[b] ? outside(rules, c, b)
                                     : fmt::format("it is outside block {}", b + 1));
    if (!decision.crossing)
      return lines;
  } else if (blocks.convex[b])
    lines.push_back(fmt::format(
        "it is inside block {}: behind all its edges, up to 1e-6 of their lengths",
        b + 1));
  for (int e = blocks.first_corner[b]; e < blocks.first_corner[b + 1]; ++e) {
    const EdgeStory edge = rules.examine(c, e);
    lines.push_back(fmt::format("edge {}: {}: {}", number(blocks, e),
                                numbers(blocks, edge), verdict(rules, decision, edge)));
  }
  if (const std::string joints = on_joints(rules, decision);
      !decision.possible.empty() && !joints.empty())
    lines.push_back(joints);
  return lines;
}

std::string tell(const Blocks& blocks, const MissedPair& missed) {
  return fmt::format("the contact list misses {} against edge {} of block {}, {}",
                     name_of(blocks, missed.corner), number(blocks, missed.edge),
                     blocks.corner_block[missed.edge] + 1,
                     missed.acts ? "which acts"
                     : missed.overlap >= 0.0
                         ? fmt::format("{:.6g} deep", missed.overlap)
                         : fmt::format("{:.6g} beyond its line", -missed.overlap));
}

std::string tell(const Blocks& blocks, const WrongDecision& wrong) {
  const auto edge = [&](int e) {
    return e < 0 ? std::string("no edge") : fmt::format("edge {}", number(blocks, e));
  };
  return fmt::format("wrong decision: {} against block {}: {} acts, exactly it is {}",
                     name_of(blocks, wrong.corner), wrong.block + 1, edge(wrong.acting),
                     edge(wrong.exact));
}

std::string tell(const ExcessOverlap& excess) {
  return fmt::format("blocks {} and {} overlap by {:.6g} near ({:.6g}, {:.6g}), their "
                     "deepest contact by {:.6g} (springs pressed in by {:.6g}): {:.6g} "
                     "more than the contacts explain",
                     excess.first + 1, excess.second + 1, excess.depth,
                     excess.place.x(), excess.place.y(), excess.explained,
                     excess.pressed, excess.excess());
}

std::string tell(const Blocks& blocks, const DeepContact& deep) {
  const int b = blocks.corner_block[deep.edge];
  const Vec2 at = blocks.corner.col(deep.corner);
  return fmt::format("{} at ({:.9g}, {:.9g}) acts {:.6g} deep on edge {} of block {} "
                     "(spring pressed in by {:.6g}), but along its normal the two "
                     "blocks have only {:.6g} in common",
                     name_of(blocks, deep.corner), at.x(), at.y(), deep.overlap,
                     number(blocks, deep.edge), b + 1, deep.pressed, deep.common);
}

}  // namespace blocks::audit
