#include "report/outcome_labels.hpp"

#include <map>

namespace blocks::report {
namespace {

constexpr quantities::Dimension pure{}, length{1, 0, 0, "m", ""},
    area{2, 0, 0, "m²", ""}, per_length{-1, 0, 0, "1/m", ""},
    degrees{0, 0, 0, "degrees", "degrees"};

/// docs/distributions.md#measures-of-generated-blocks,
/// docs/robustness.md#what-is-counted
const std::map<std::string, MeasureLabel> labels = {
    {"layers", {"LAYER cards", pure}},
    {"blocks", {"blocks", pure}},
    {"absorbed", {"blocks absorbed by MERGE", pure}},
    {"angles_redrawn", {"angles drawn again", pure}},
    {"sides_redrawn", {"sides with an angle drawn again", pure}},
    {"sides_ruled", {"sides that take the ruling", pure}},
    {"area", {"area", area}},
    {"aspect", {"aspect ratio", pure}},
    {"shortest_side", {"shortest side", length}},
    {"smallest_angle", {"smallest angle", degrees}},
    {"width", {"width", length}},
    {"p21", {"P21, length of joints over area", per_length}},
    {"t_vertices", {"T vertices", pure}},
    {"x_vertices", {"X vertices", pure}},
    {"certificate", {"certificate: no two blocks overlap", pure}},
    {"overlaps", {"pairs of blocks that overlap", pure}},
    {"gaps", {"gaps between blocks", pure}},
    {"fos", {"factor of safety", pure}},
    {"fos_lower", {"factor of safety, proved lower end", pure}},
    {"fos_upper", {"factor of safety, proved upper end", pure}},
    {"could_hang", {"frames in which something could hang", pure}},
    {"hung", {"hang-ups", pure}},
    {"fell", {"fall-throughs", pure}},
    {"wrong_signs", {"wrong signs of (19), share", pure}},
    {"wrong_tangents", {"wrong answers to (20), share", pure}},
    {"phantom", {"phantom contacts, share of those that act", pure}},
    {"missed", {"missed contacts, share of those that should act", pure}},
    {"speed_lost", {"speed lost", pure}},
    {"energy_error", {"energy error", pure}},
    {"diverged", {"frames that differ from default", pure}},
    {"diverged_step", {"first step that differs from default", pure}},
    {"shortest_side:min", {"shortest side of all blocks", length}},
    {"smallest_angle:min", {"smallest angle of all blocks", degrees}}};

/// Words before a value of each block.
const std::map<std::string, std::string> parts = {
    {"min", "smallest"},          {"mean", "mean"},
    {"max", "largest"},           {"sd", "standard deviation of"},
    {"p5", "5th percentile of"},  {"p50", "median"},
    {"p95", "95th percentile of"}};

}  // namespace

MeasureLabel label_of_outcome(const std::string& name) {
  if (const auto whole = labels.find(name); whole != labels.end())
    return whole->second;
  const auto colon = name.find(':');
  const auto label = labels.find(name.substr(0, colon));
  if (label == labels.end())
    return {name, pure};
  const auto part = parts.find(name.substr(colon + 1));
  if (part == parts.end())
    return {name, label->second.dimension};
  return {part->second + " " + label->second.label + " of the blocks",
          label->second.dimension};
}

}  // namespace blocks::report
