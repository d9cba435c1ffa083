#include "model/words/crack_report.hpp"

#include <fmt/format.h>

namespace blocks {
namespace {

std::string named_material(const Settings& settings, int number) {
  const auto found = settings.materials.find(number);
  return found == settings.materials.end() || found->second.name.empty()
             ? fmt::format("material {}", number)
             : fmt::format("material {} ({})", number, found->second.name);
}

}  // namespace

const char* describe(CrackCause cause) {
  return cause == CrackCause::stress ? "stress" : "point loads";
}

std::string crack_report(const Settings& settings) {
  std::string text;
  for (const auto& [number, rule] : settings.crack_rules) {
    text += fmt::format("{}: blocks split at a tension of {:g}",
                        named_material(settings, number), rule.strength);
    if (rule.point_strength > 0.0)
      text += fmt::format(", under point loads at {:g}", rule.point_strength);
    text += fmt::format("; least area of a piece {:g}; ", rule.min_area);
    text += rule.joint > 0 ? fmt::format("new faces have joint id {}\n", rule.joint)
                           : "new faces have no joint id\n";
  }
  for (const auto& [number, material] : settings.materials)
    if (material.damping > 0.0)
      text += fmt::format("{}: vibration of blocks damped by {:g} of critical{}\n",
                          named_material(settings, number), material.damping,
                          settings.rigid ? ", without effect on rigid blocks" : "");
  return text;
}

}  // namespace blocks
