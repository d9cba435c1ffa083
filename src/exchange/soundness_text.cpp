#include "exchange/soundness_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/counted.hpp"

namespace blocks::exchange {
namespace {

constexpr std::size_t shown = 5;
// Number of overlapping pairs listed, the largest ones.
constexpr std::size_t max_pairs = 10;

/// Returns a line "  ...\n" for each of the first few items.
template <class Items, class Text>
std::string first_few(const Items& items, Text text_of) {
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), shown); ++i)
    text += "  " + text_of(items[i]) + "\n";
  if (items.size() > shown)
    text += fmt::format("  and {} more\n", items.size() - shown);
  return text;
}

std::string near(const geometry::Vec2& place) {
  return fmt::format("({:.9g}, {:.9g})", place.x(), place.y());
}

std::string totals(const std::vector<Outline>& outlines) {
  geometry::Vec2 lower = outlines[0].corners[0], upper = lower;
  std::size_t corners = 0;
  for (const Outline& outline : outlines)
    for (const geometry::Vec2& corner : outline.corners) {
      ++corners;
      lower = lower.cwiseMin(corner);
      upper = upper.cwiseMax(corner);
    }
  return fmt::format("{}, {}, x {:.9g} to {:.9g}, y {:.9g} to {:.9g}\n",
                     counted(outlines.size(), "block"), counted(corners, "corner"),
                     lower.x(), upper.x(), lower.y(), upper.y());
}

}  // namespace

std::vector<Message> faults(const Soundness& soundness,
                            const std::vector<Outline>& outlines, bool keep_overlaps) {
  std::vector<Message> messages;
  for (const BadOutline& bad : soundness.bad)
    messages.push_back(
        {true, outlines[bad.block].at,
         fmt::format("block {}: {}", bad.block + 1, geometry::describe(bad.check)),
         "give the corners in order around the block, each one once"});
  std::vector<geometry::BlockOverlap> largest = soundness.overlaps;
  std::stable_sort(largest.begin(), largest.end(),
                   [](const auto& a, const auto& b) { return a.area > b.area; });
  const std::string hint =
      keep_overlaps ? "" : "correct the outlines, or accept them with --keep-overlaps";
  for (std::size_t i = 0; i < std::min(largest.size(), max_pairs); ++i) {
    const geometry::BlockOverlap& pair = largest[i];
    messages.push_back(
        {!keep_overlaps, outlines[pair.first].at,
         fmt::format("blocks {} and {} overlap by an area of {} near ({:.6g}, "
                     "{:.6g})",
                     pair.first + 1, pair.second + 1,
                     geometry::positive_text(pair.area, 3), pair.place.x(),
                     pair.place.y()),
         hint, 0});
  }
  if (largest.size() > max_pairs)
    messages.push_back({!keep_overlaps, nowhere,
                        fmt::format("{} more pairs of blocks overlap, by less",
                                    largest.size() - max_pairs),
                        hint});
  return messages;
}

std::string describe(const Soundness& soundness, const std::vector<Outline>& outlines) {
  if (outlines.empty())
    return {};
  std::string text = totals(outlines);
  if (!soundness.turned.empty())
    text += fmt::format("turned clockwise, corner 1 kept: {}\n",
                        counted(soundness.turned.size(), "block"));
  if (!soundness.concave.empty())
    text +=
        fmt::format("not convex: {}\n", counted(soundness.concave.size(), "block")) +
        first_few(soundness.concave,
                  [](int b) { return fmt::format("block {}", b + 1); });
  if (!soundness.roundings.empty())
    text += fmt::format("overlapping by no more than rounding: {}\n",
                        counted(soundness.roundings.size(), "pair"));
  const geometry::Joints& joints = soundness.joints;
  if (!joints.t_junctions.empty())
    text += fmt::format("T-junctions, corners inside another block's side: {}\n",
                        joints.t_junctions.size()) +
            first_few(joints.t_junctions, [](const geometry::TJunction& junction) {
              return fmt::format("corner {} of block {} on block {} at {}",
                                 junction.corner + 1, junction.block + 1,
                                 junction.other + 1, near(junction.place));
            });
  if (!joints.slits.empty())
    text += fmt::format("gaps between blocks that nearly touch: {}\n",
                        joints.slits.size()) +
            first_few(joints.slits, [](const geometry::Slit& slit) {
              return fmt::format("blocks {} and {}: {:.3g} wide at {}", slit.first + 1,
                                 slit.second + 1, slit.width, near(slit.place));
            });
  if (soundness.slits_by_rounding > 0)
    text += fmt::format("slits made by rounding: {}\n", soundness.slits_by_rounding);
  return text;
}

}  // namespace blocks::exchange
