#include "why_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "audit/words.hpp"

namespace blocks::apps {
namespace {

using Json = nlohmann::ordered_json;

int number(const Blocks& blocks, int corner) {
  return corner - blocks.first_corner[blocks.corner_block[corner]] + 1;
}

std::string kind(const Blocks& blocks, int b) {
  return fmt::format("block {} ({}{} corners)", b + 1,
                     blocks.is_free(b) ? "" : "fixed, ", blocks.corners_of(b));
}

/// What the file remembers of the edges of a block against a corner.
std::vector<std::string> remembered(const WhyScene& scene,
                                    const audit::Decision& decision) {
  const Blocks& blocks = scene.blocks;
  std::vector<std::string> lines;
  const int b = decision.block;
  std::string unlisted;
  for (int e = blocks.first_corner[b]; e < blocks.first_corner[b + 1]; ++e) {
    const RememberedContact* contact = scene.find(decision.corner, e);
    if (contact == nullptr)
      unlisted += fmt::format("{}{}", unlisted.empty() ? "" : ", ", number(blocks, e));
    else if (contact->active)
      lines.push_back(fmt::format("in the file: edge {} acted in the step before: "
                                  "normal force {:.6g}, shear force {:.6g}, overlap "
                                  "{:.6g}",
                                  number(blocks, e), contact->normal_force,
                                  contact->shear_force, contact->overlap));
  }
  if (lines.empty())
    lines.push_back("in the file: no edge acted in the step before");
  if (scene.listed && !unlisted.empty())
    lines.push_back("in the file: not in the list of potential contacts: edges " +
                    unlisted);
  return lines;
}

/// The deepest of the contacts that act, [L]; 0: none.
double deepest(const WhyReport& report, const audit::ExactRules& rules) {
  double depth = 0.0;
  for (const audit::Decision& decision : report.decisions)
    for (const int edge : {decision.acting, decision.notch})
      if (edge >= 0)
        depth = std::max(depth, rules.overlap(decision.corner, edge));
  return depth;
}

std::string explained(const WhyReport& report, const audit::ExactRules& rules) {
  const double depth = deepest(report, rules);
  return depth > 0.0 ? fmt::format("their deepest contact is {:.6g}", depth)
                     : "no contact explains it";
}

const char* word(audit::Answer answer) {
  return answer == audit::Answer::yes  ? "yes"
         : answer == audit::Answer::no ? "no"
                                       : "by rounding";
}

Json edge_number(const Blocks& blocks, int edge) {
  return edge < 0 ? Json() : Json(number(blocks, edge));
}

Json edges(const WhyScene& scene, const audit::ExactRules& rules,
           const audit::Decision& decision) {
  const Blocks& blocks = scene.blocks;
  Json list = Json::array();
  const int b = decision.block;
  for (int e = blocks.first_corner[b]; e < blocks.first_corner[b + 1]; ++e) {
    const audit::EdgeStory edge = rules.examine(decision.corner, e);
    Json one = {{"edge", number(blocks, e)},
                {"overlap", edge.overlap},
                {"overlap_sign", edge.overlap_sign},
                {"depth_limit", edge.depth_limit},
                {"within_depth", edge.within_depth},
                {"along", edge.along},
                {"between", edge.between},
                {"tangents", {edge.tangent_before, edge.tangent_after}},
                {"facing", {edge.facing_before, edge.facing_after}},
                {"admissible", edge.admissible},
                {"acts", decision.acts(e)},
                {"verdict", audit::verdict(rules, decision, edge)}};
    const RememberedContact* contact = scene.find(decision.corner, e);
    if (scene.listed)
      one["listed"] = contact != nullptr;
    one["step_before"] = contact == nullptr || !contact->active
                             ? Json()
                             : Json{{"normal_force", contact->normal_force},
                                    {"shear_force", contact->shear_force},
                                    {"overlap", contact->overlap}};
    list.push_back(one);
  }
  return list;
}

Json shield(const Blocks& blocks, const audit::Shield& shield) {
  Json answer = {{"hidden", word(shield.answer)}};
  if (shield.third >= 0) {
    answer["by_block"] = shield.third + 1;
    answer["corner"] = {{"block", blocks.corner_block[shield.corner] + 1},
                        {"corner", number(blocks, shield.corner)}};
    answer["depth"] = shield.depth;
    answer["reach"] = shield.reach;
  }
  return answer;
}

/// What closed joints hide: the nearest edge, or the corner.
Json joints(const Blocks& blocks, const audit::Decision& decision) {
  if (decision.possible.empty() || decision.notch >= 0)
    return nullptr;
  return {{"side", shield(blocks, decision.side)},
          {"corner", shield(blocks, decision.hidden)}};
}

}  // namespace

WhyReport why(const WhyScene& scene, const audit::ExactRules& rules, int first,
              int second) {
  const Blocks& blocks = scene.blocks;
  WhyReport report;
  report.first = first, report.second = second;
  for (const auto& [own, other] : {std::pair(first, second), {second, first}})
    for (int c = blocks.first_corner[own]; c < blocks.first_corner[own + 1]; ++c)
      for (const int b : rules.near(c))
        if (b == other)
          report.decisions.push_back(rules.decide(c, b));
  const auto overlaps =
      geometry::overlapping_pairs({blocks.outline(first), blocks.outline(second)});
  if (!overlaps.empty())
    report.overlap = overlaps.front();
  return report;
}

std::string text(const WhyReport& report, const WhyScene& scene,
                 const audit::ExactRules& rules) {
  const Blocks& blocks = scene.blocks;
  std::string out = fmt::format("{}: ", report.file);
  if (scene.times.size() > 1)
    out += fmt::format("frame {} of {}, ", scene.frame + 1, scene.times.size());
  out += fmt::format("time {:.9g} (step {})", scene.time, scene.step);
  if (report.asked && *report.asked != scene.time)
    out += fmt::format(", the nearest to {:.9g}", *report.asked);
  out += fmt::format("\n{} and {}: what the next step decides, by the exact rules\n",
                     kind(blocks, report.first), kind(blocks, report.second));
  if (!scene.listed)
    out +=
        "(rebuilt from the geometry: the file holds no list of potential contacts)\n";
  if (report.overlap)
    out += fmt::format("they overlap by {}, an area of {} near ({:.6g}, {:.6g}); {}\n",
                       geometry::positive_text(report.overlap->depth, 6),
                       geometry::positive_text(report.overlap->area, 6),
                       report.overlap->place.x(), report.overlap->place.y(),
                       explained(report, rules));
  else
    out += "they do not overlap\n";
  for (const audit::Decision& decision : report.decisions) {
    out += '\n';
    const auto lines = audit::story(rules, decision);
    out += lines.front() + '\n';
    for (std::size_t i = 1; i < lines.size(); ++i)
      out += "  " + lines[i] + '\n';
    for (const std::string& line : remembered(scene, decision))
      out += "  " + line + '\n';
  }
  return out;
}

std::string json(const WhyReport& report, const WhyScene& scene,
                 const audit::ExactRules& rules) {
  const Blocks& blocks = scene.blocks;
  Json pairs = Json::array();
  for (const audit::Decision& decision : report.decisions) {
    const int c = decision.corner;
    pairs.push_back({{"block", blocks.corner_block[c] + 1},
                     {"corner", number(blocks, c)},
                     {"at", {blocks.corner(0, c), blocks.corner(1, c)}},
                     {"against", decision.block + 1},
                     {"inside", decision.inside},
                     {"acting", edge_number(blocks, decision.acting)},
                     {"acting_across_notch", edge_number(blocks, decision.notch)},
                     {"nearest", edge_number(blocks, decision.nearest)},
                     {"next", edge_number(blocks, decision.next)},
                     {"joints", joints(blocks, decision)},
                     {"edges", edges(scene, rules, decision)}});
  }
  const Json all = {
      {"file", report.file},
      {"time", scene.time},
      {"step", scene.step},
      {"frame", scene.frame},
      {"blocks", {report.first + 1, report.second + 1}},
      {"contact_list", scene.listed ? "stored" : "rebuilt from the geometry"},
      {"overlap", report.overlap ? Json{{"depth", report.overlap->depth},
                                        {"area", report.overlap->area},
                                        {"deepest_contact", deepest(report, rules)}}
                                 : Json()},
      {"corners", pairs}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace blocks::apps
