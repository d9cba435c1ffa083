#include "audit/story.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "audit/words.hpp"

namespace blocks::audit {
namespace {

std::string percent(double share) { return fmt::format("{:.3g} %", 100.0 * share); }

/// Names the block of a part, and also the part if the block has several.
std::string name_of_part(const ExactPairRule& rule, int part) {
  const std::vector<ConvexPart>& parts = rule.parts();
  const int block = parts[part].block;
  int first = part, end = part;
  while (first > 0 && parts[first - 1].block == block)
    --first;
  while (end < static_cast<int>(parts.size()) && parts[end].block == block)
    ++end;
  if (end - first == 1)
    return fmt::format("block {}", block + 1);
  return fmt::format("part {} of block {}", part - first + 1, block + 1);
}

std::string words(Entry entry) {
  switch (entry) {
  case Entry::inside:
    return "entered: its corner is outside no other side";
  case Entry::other_end:
    return "entered: the other end of its facing side is inside";
  case Entry::foot:
    return "entered: the foot of its corner is beyond an end of the side";
  case Entry::crossing:
    return "entered: sides of the two blocks cross at its end";
  case Entry::none:
    break;
  }
  return "not entered: its corner has passed another side";
}

std::string words(const ExactPairRule& rule, const Axis& axis,
                  const HidingJoint& hiding) {
  const std::string why = words(rule, hiding.joint);
  switch (hiding.place) {
  case HidingPlace::axis_side:
    return "hidden by a closed joint: " + why;
  case HidingPlace::facing_side:
    return "hidden by a closed joint of its facing side: " + why;
  case HidingPlace::corner:
    break;
  }
  return fmt::format("hidden, because a closed joint hides {} from the side: {}",
                     name_of(rule.blocks(), axis.corner), why);
}

/// Says which closed joints hide the axis, and which surface takes over.
std::string hiding_in_words(const ExactPairRule& rule, const PartDecision& decision,
                            const Axis& axis) {
  if (axis.hidden_by.empty())
    return axis.rise_keeps_it_visible
               ? "not hidden: beyond the closed joint the surface rises towards the "
                 "side"
               : "not hidden";
  std::string text;
  for (const HidingJoint& hiding : axis.hidden_by)
    text += words(rule, axis, hiding) + "; ";
  return text + "the surface that takes over is " +
         name_of(rule.blocks(), decision.axes[axis.taken_over_by].side);
}

std::string result_in_words(const PartDecision& decision, int axis) {
  if (axis == decision.chosen)
    switch (decision.choice) {
    case Choice::no_entry:
      return "is used instead, because no axis is entered and this is the least";
    case Choice::no_contact:
      return "is used instead, because no contact acts along the first entered axis "
             "and "
             "this is the least";
    case Choice::still_hidden:
      return "is used instead, because the surfaces that take over are hidden too and "
             "this "
             "is the first entered axis";
    case Choice::surface:
      return "acts as the surface that has taken over";
    default:
      return "acts";
    }
  if (!decision.path.empty() && axis == decision.path.front()) {
    if (decision.choice == Choice::inner_side)
      return "does not act, because the part beside the inner side decides";
    if (decision.choice == Choice::no_contact)
      return "does not act, because no contact acts along it";
  }
  return "does not act";
}

/// Returns the axes that the choice has used: those that were tested for entry, by
/// depth, then the surfaces that took over, then an axis that is used instead.
std::vector<int> used_axes(const PartDecision& decision) {
  std::vector<int> used;
  const auto add = [&](int axis) {
    if (axis >= 0 && std::find(used.begin(), used.end(), axis) == used.end())
      used.push_back(axis);
  };
  for (int i = 0; i < static_cast<int>(decision.axes.size()); ++i)
    if (decision.axes[i].entry_known)
      add(i);
  for (const int axis : decision.path)
    add(axis);
  add(decision.chosen);
  return used;
}

void add_axes(const ExactPairRule& rule, const PartDecision& decision,
              std::vector<std::string>& lines) {
  const Blocks& blocks = rule.blocks();
  const std::vector<int> used = used_axes(decision);
  for (const int i : used) {
    const Axis& axis = decision.axes[i];
    const std::string facing =
        axis.facing ? "facing " + name_of(blocks, *axis.facing) : "no facing side";
    lines.push_back(fmt::format(
        "axis of {}: {} is {:.6g} deep, {}: {}", name_of(blocks, axis.side),
        name_of(blocks, axis.corner), axis.depth, facing, verdict(rule, decision, i)));
  }
  const std::size_t rest = decision.axes.size() - used.size();
  if (rest > 0)
    lines.push_back(fmt::format("the choice does not use the other {} axes", rest));
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

std::string words(const ExactPairRule& rule, const Joint& joint) {
  const Blocks& blocks = rule.blocks();
  const std::string where =
      fmt::format("at {} the surface of {}", name_of(blocks, joint.corner),
                  name_of(blocks, joint.surface));
  if (joint.surface_inner)
    return where + " is an inner side, so the joint is open";
  if (joint.side.inner)
    return where + " goes on in the part beside it";
  if (joint.centroid_below)
    return fmt::format("{} has the centroid of {} inside, so the joint is open", where,
                       name_of_part(rule, joint.against_part));
  if (!joint.cover.side)
    return fmt::format("{} ends, since no neighbour covers {}", where,
                       name_of(blocks, joint.side));
  return fmt::format("{} {}: neighbours cover {} of the stretch ({:.6g}) and {} of the "
                     "interval ({:.6g}) of {}, {} {}",
                     where, joint.closed ? "goes on" : "ends",
                     percent(joint.cover.share_of_stretch), joint.cover.stretch,
                     percent(joint.cover.share_of_interval), joint.cover.interval,
                     name_of(blocks, joint.side),
                     joint.closed ? "most of it by" : "less than half, most of that by",
                     name_of(blocks, *joint.cover.side));
}

std::string verdict(const ExactPairRule& rule, const PartDecision& decision, int axis) {
  const Axis& a = decision.axes[axis];
  std::string text;
  if (a.depth_sign <= 0)
    text += "not deeper than zero; ";
  if (a.entry_known)
    text += (a.far ? "far: deeper than the overlap region" : words(a.entry)) + "; ";
  if (a.joints_known)
    text += hiding_in_words(rule, decision, a) + "; ";
  return text + result_in_words(decision, axis);
}

std::string verdict(const Candidate& candidate) {
  if (candidate.acts)
    return candidate.in_notch ? "its foot is beyond the end, in a notch: acts" : "acts";
  if (!candidate.inside)
    return "refused: the corner is not inside the side";
  if (candidate.far)
    return "refused: far, deeper than the overlap region";
  if (!candidate.between)
    return "refused: its foot is not between the ends of the side (slack 1e-6)";
  return "refused: the side is an inner side";
}

std::vector<std::string> story(const ExactPairRule& rule, int a, int b,
                               const PairDecision& decision) {
  const Blocks& blocks = rule.blocks();
  std::vector<std::string> lines = {
      fmt::format("blocks {} and {}: {}", a + 1, b + 1,
                  contacts_in_words(blocks, decision.contacts))};
  for (const PartDecision& part : decision.parts) {
    const std::string pair = fmt::format("{} and {}", name_of_part(rule, part.part),
                                         name_of_part(rule, part.other));
    if (part.choice == Choice::apart) {
      lines.push_back(fmt::format("{} are apart by {:.6g} beyond {}", pair,
                                  -part.separation, name_of(blocks, part.separating)));
      continue;
    }
    if (decision.parts.size() > 1)
      lines.push_back(pair + ":");
    add_axes(rule, part, lines);
    for (const Candidate& candidate : part.candidates)
      lines.push_back(fmt::format(
          "{} on {}: {:.6g} deep: {}", name_of(blocks, candidate.corner),
          name_of(blocks, candidate.side), candidate.depth, verdict(candidate)));
  }
  return lines;
}

}  // namespace blocks::audit
