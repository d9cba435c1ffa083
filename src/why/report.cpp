#include "why/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "audit/story.hpp"
#include "audit/words.hpp"
#include "quantities/bond.hpp"

namespace blocks::why {
namespace {

using Json = nlohmann::ordered_json;

Json place(const Blocks& blocks, int corner) {
  return {{"block", blocks.corner_block[corner] + 1},
          {"corner", audit::number_in_block(blocks, corner)}};
}

/// Returns a side by its two corners; an edge of the block also has its number.
Json side(const Blocks& blocks, const audit::PartSide& side) {
  Json one = {{"block", blocks.corner_block[side.start] + 1},
              {"from", audit::number_in_block(blocks, side.start)},
              {"to", audit::number_in_block(blocks, side.end)}};
  one["edge"] = side.inner ? Json() : Json(audit::number_in_block(blocks, side.start));
  return one;
}

const char* word(audit::Choice choice) {
  switch (choice) {
  case audit::Choice::apart:
    return "apart";
  case audit::Choice::touching:
    return "least axis touches";
  case audit::Choice::axis:
    return "axis acts";
  case audit::Choice::least_axis:
    return "least axis acts";
  case audit::Choice::none:
    break;
  }
  return "carried";
}

const char* word(audit::Bound bound) {
  switch (bound) {
  case audit::Bound::separating_shift:
    return "separating shift";
  case audit::Bound::common_diameter:
    return "common diameter";
  case audit::Bound::third_part:
    break;
  }
  return "third part";
}

Json slide(const audit::Blocking::Slide& slide) {
  return {{"length", slide.length}, {"rest", slide.rest}};
}

Json blocking(const audit::ExactPairRule& rule, const audit::Blocking& third) {
  return {{"block", rule.parts()[third.part].block + 1},
          {"third_part_of", third.whose == audit::ThirdOf::own ? "own" : "other"},
          {"overlap", third.overlap},
          {"slides", {slide(third.shorter), slide(third.longer)}},
          {"hides", third.hides}};
}

Json axes(const audit::ExactPairRule& rule, const audit::PartDecision& part) {
  const Blocks& blocks = rule.blocks();
  Json list = Json::array();
  for (int i = 0; i < static_cast<int>(part.axes.size()); ++i) {
    const audit::Axis& axis = part.axes[i];
    Json one = {{"side", side(blocks, axis.side)},
                {"corner", place(blocks, axis.corner)},
                {"depth", axis.depth},
                {"facing", axis.facing ? side(blocks, *axis.facing) : Json()},
                {"examined", axis.examined}};
    if (axis.examined) {
      one["skipped"] = axis.skipped;
      one["far"] =
          axis.far ? Json{{"bound", word(axis.far->bound)}, {"twice", axis.far->twice}}
                   : Json();
      Json thirds = Json::array();
      for (const audit::Blocking& third : axis.blocking)
        thirds.push_back(blocking(rule, third));
      one["blocking"] = thirds;
    }
    one["acts"] = i == part.chosen && part.choice != audit::Choice::none;
    one["verdict"] = audit::verdict(rule, part, i);
    list.push_back(one);
  }
  return list;
}

Json candidates(const audit::ExactPairRule& rule, const audit::PartDecision& part) {
  const Blocks& blocks = rule.blocks();
  Json list = Json::array();
  for (const audit::Candidate& candidate : part.candidates)
    list.push_back({{"corner", place(blocks, candidate.corner)},
                    {"side", side(blocks, candidate.side)},
                    {"depth", candidate.depth},
                    {"inside", candidate.inside},
                    {"between", candidate.between},
                    {"acts", candidate.acts},
                    {"verdict", audit::verdict(rule, candidate)}});
  return list;
}

/// Returns the contacts between the two blocks that are stored in the file.
std::vector<RememberedContact> remembered(const Report& report, const Scene& scene) {
  std::vector<RememberedContact> found;
  for (const RememberedContact& contact : scene.contacts)
    if (std::minmax({scene.blocks.corner_block[contact.corner],
                     scene.blocks.corner_block[contact.edge]}) ==
        std::pair(report.first, report.second))
      found.push_back(contact);
  return found;
}

/// Returns the mean stress of a contact, [F/L^2]; 0 if no face belongs to it.
double stress_of(double force, const LawState& state) {
  return state.length > 0.0 ? force / state.length : 0.0;
}

/// Returns a text in lines of at most 100 columns.
std::string lines_of(std::size_t indent, const std::string& text) {
  std::string out;
  for (const std::string& line : audit::in_lines(text, indent, 100))
    out += line + '\n';
  return out;
}

/// Describes the state of the law of a contact, and what it means for the next step.
std::string state_in_words(const Blocks& blocks, const RememberedContact& contact) {
  const LawState& state = contact.state;
  std::string out = lines_of(
      4,
      fmt::format("law of joint {}: {}, slip {:.6g}, dilation {:.6g}, length {:.6g}, "
                  "normal stress {:.6g}, shear stress {:.6g}",
                  state.law, word(quantities::bond_of(state.bonded, state.failed)),
                  state.slip, state.offset, state.length,
                  stress_of(contact.normal_force, state),
                  stress_of(contact.shear_force, state)));
  if (state.bonded)
    out += lines_of(4, fmt::format("bonded, so it acts in the next step whatever the "
                                   "rule decides, and {} acts on no other edge of "
                                   "block {}",
                                   audit::name_of(blocks, contact.corner),
                                   blocks.corner_block[contact.edge] + 1));
  else if (state.offset > 0.0)
    out += lines_of(4, "it also acts in the next step while overlap and dilation sum "
                       "to more than 0 between the ends of the edge");
  return out;
}

/// Returns the depth of the deepest acting contact [L]; 0 if there is none.
double deepest(const Report& report, const audit::ExactPairRule& rule) {
  double depth = 0.0;
  for (const auto& [corner, edge] : report.decision.contacts)
    depth = std::max(depth, rule.overlap(corner, edge));
  return depth;
}

std::string kind(const Blocks& blocks, int b) {
  return fmt::format("block {} ({}{} corners)", b + 1,
                     blocks.is_free(b) ? "" : "fixed, ", blocks.corners_of(b));
}

std::string overlap_in_words(const Report& report, const audit::ExactPairRule& rule) {
  if (!report.overlap)
    return "they do not overlap\n";
  const double depth = deepest(report, rule);
  return fmt::format("they overlap by {}, an area of {} near ({:.6g}, {:.6g})\n{}\n",
                     geometry::positive_text(report.overlap->depth, 6),
                     geometry::positive_text(report.overlap->area, 6),
                     report.overlap->place.x(), report.overlap->place.y(),
                     depth > 0.0 ? fmt::format("their deepest contact is {:.6g}", depth)
                                 : "no contact acts");
}

}  // namespace

Report explain(const audit::ExactPairRule& rule, int first, int second) {
  const Blocks& blocks = rule.blocks();
  Report report;
  report.first = first, report.second = second;
  report.decision = rule.decide(first, second);
  const auto overlaps =
      geometry::overlapping_pairs({blocks.outline(first), blocks.outline(second)});
  if (!overlaps.empty())
    report.overlap = overlaps.front();
  return report;
}

std::string text(const Report& report, const Scene& scene,
                 const audit::ExactPairRule& rule) {
  const Blocks& blocks = scene.blocks;
  std::string out = fmt::format("{}: ", report.file);
  if (scene.times.size() > 1)
    out += fmt::format("frame {} of {}, ", scene.frame + 1, scene.times.size());
  out += fmt::format("time {:.9g} (step {})", scene.time, scene.step);
  if (report.requested && *report.requested != scene.time)
    out += fmt::format(", the nearest to {:.9g}", *report.requested);
  out += fmt::format("\n{} and {}: what the next step decides, by the exact rule\n",
                     kind(blocks, report.first), kind(blocks, report.second));
  out += overlap_in_words(report, rule) + '\n';
  const auto lines = audit::story(rule, report.first, report.second, report.decision);
  out += lines.front() + '\n';
  for (std::size_t i = 1; i < lines.size(); ++i)
    out += "  " + lines[i] + '\n';
  const auto contacts = remembered(report, scene);
  for (const RememberedContact& contact : contacts) {
    out += fmt::format("  in the file: {} on {} acted in the step before:\n"
                       "    normal force {:.6g}, shear force {:.6g}, overlap {:.6g}\n",
                       audit::name_of(blocks, contact.corner),
                       audit::name_of_edge(blocks, contact.edge), contact.normal_force,
                       contact.shear_force, contact.overlap);
    if (contact.state.law != 0)
      out += state_in_words(blocks, contact);
  }
  if (contacts.empty())
    out += "  in the file: no contact acted in the step before\n";
  return out;
}

std::string json(const Report& report, const Scene& scene,
                 const audit::ExactPairRule& rule) {
  const Blocks& blocks = scene.blocks;
  Json contacts = Json::array(), before = Json::array(), parts = Json::array();
  for (const auto& [corner, edge] : report.decision.contacts)
    contacts.push_back({{"corner", place(blocks, corner)},
                        {"block", blocks.corner_block[edge] + 1},
                        {"edge", audit::number_in_block(blocks, edge)},
                        {"depth", rule.overlap(corner, edge)}});
  for (const RememberedContact& contact : remembered(report, scene)) {
    before.push_back({{"corner", place(blocks, contact.corner)},
                      {"block", blocks.corner_block[contact.edge] + 1},
                      {"edge", audit::number_in_block(blocks, contact.edge)},
                      {"normal_force", contact.normal_force},
                      {"shear_force", contact.shear_force},
                      {"overlap", contact.overlap}});
    if (const LawState& state = contact.state; state.law != 0)
      before.back()["law"] = {
          {"joint", state.law},
          {"bond", word(quantities::bond_of(state.bonded, state.failed))},
          {"slip", state.slip},
          {"dilation", state.offset},
          {"plastic_closure", state.plastic},
          {"length", state.length},
          {"normal_stress", stress_of(contact.normal_force, state)},
          {"shear_stress", stress_of(contact.shear_force, state)}};
  }
  for (const audit::PartDecision& part : report.decision.parts)
    parts.push_back({{"choice", word(part.choice)},
                     {"axes", axes(rule, part)},
                     {"candidates", candidates(rule, part)}});
  const Json all = {{"file", report.file},
                    {"time", scene.time},
                    {"step", scene.step},
                    {"frame", scene.frame},
                    {"blocks", {report.first + 1, report.second + 1}},
                    {"overlap", report.overlap
                                    ? Json{{"depth", report.overlap->depth},
                                           {"area", report.overlap->area},
                                           {"deepest_contact", deepest(report, rule)}}
                                    : Json()},
                    {"contacts", contacts},
                    {"step_before", before},
                    {"parts", parts}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace blocks::why
