#include "why_pair_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "audit/pair_words.hpp"
#include "audit/words.hpp"

namespace blocks::apps {
namespace {

using Json = nlohmann::ordered_json;

int number(const Blocks& blocks, int corner) {
  return corner - blocks.first_corner[blocks.corner_block[corner]] + 1;
}

Json place(const Blocks& blocks, int corner) {
  return {{"block", blocks.corner_block[corner] + 1},
          {"corner", number(blocks, corner)}};
}

/// A side by its corners; an edge of a block has its number as well.
Json side(const Blocks& blocks, const audit::PartSide& side) {
  Json one = {{"block", blocks.corner_block[side.start] + 1},
              {"from", number(blocks, side.start)},
              {"to", number(blocks, side.end)}};
  one["edge"] = side.inner ? Json() : Json(number(blocks, side.start));
  return one;
}

const char* word(audit::Choice choice) {
  switch (choice) {
  case audit::Choice::apart:
    return "apart";
  case audit::Choice::touching:
    return "least axis touches";
  case audit::Choice::entered:
    return "first entered axis acts";
  case audit::Choice::surface:
    return "surface takes over";
  case audit::Choice::inner_side:
    return "part beside inner side decides";
  case audit::Choice::no_entry:
    return "no axis entered, least axis stands in";
  case audit::Choice::no_contact:
    return "no contact, least axis stands in";
  case audit::Choice::still_hidden:
    break;
  }
  return "surfaces hidden, first entered axis stands in";
}

const char* word(audit::Entry entry) {
  switch (entry) {
  case audit::Entry::inside:
    return "inside";
  case audit::Entry::foot:
    return "foot";
  case audit::Entry::crossing:
    return "crossing";
  case audit::Entry::none:
    break;
  }
  return "no";
}

const char* word(audit::HidingPlace place) {
  switch (place) {
  case audit::HidingPlace::axis_side:
    return "axis side";
  case audit::HidingPlace::facing_side:
    return "facing side";
  case audit::HidingPlace::corner:
    break;
  }
  return "corner";
}

Json joint(const Blocks& blocks, const audit::Joint& joint) {
  Json one = place(blocks, joint.corner);
  one["side"] = side(blocks, joint.side);
  one["surface"] = side(blocks, joint.surface);
  one["stretch"] = joint.cover.stretch;
  one["interval"] = joint.cover.interval;
  one["share_of_stretch"] = joint.cover.share_of_stretch;
  one["share_of_interval"] = joint.cover.share_of_interval;
  one["covered_by"] = joint.cover.side ? side(blocks, *joint.cover.side) : Json();
  return one;
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
    if (axis.examined)
      one["entered"] = word(axis.entry);
    if (axis.looked_at) {
      Json joints = Json::array();
      for (const audit::HidingJoint& hiding : axis.hidden_by) {
        Json closed = joint(blocks, hiding.joint);
        closed["place"] = word(hiding.place);
        joints.push_back(closed);
      }
      one["hidden_by"] = joints;
      one["taken_over_by"] = axis.taken_over_by >= 0
                                 ? side(blocks, part.axes[axis.taken_over_by].side)
                                 : Json();
    }
    one["acts"] = i == part.chosen;
    if (axis.examined || axis.looked_at || i == part.chosen)
      one["verdict"] = audit::verdict(rule, part, i);
    list.push_back(one);
  }
  return list;
}

Json candidates(const Blocks& blocks, const audit::PartDecision& part) {
  Json list = Json::array();
  for (const audit::Candidate& candidate : part.candidates)
    list.push_back({{"corner", place(blocks, candidate.corner)},
                    {"side", side(blocks, candidate.side)},
                    {"depth", candidate.depth},
                    {"inside", candidate.inside},
                    {"between", candidate.between},
                    {"acts", candidate.acts},
                    {"verdict", audit::verdict(candidate)}});
  return list;
}

/// Calls visit(corner, edge) for all corners of either block and edges of the other.
template <class Visit>
void each_record(const Blocks& blocks, const WhyPair& pair, const Visit& visit) {
  for (const auto& [a, b] :
       {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)})
    for (int c = blocks.first_corner[a]; c < blocks.first_corner[a + 1]; ++c)
      for (int e = blocks.first_corner[b]; e < blocks.first_corner[b + 1]; ++e)
        visit(c, e);
}

}  // namespace

WhyPair why_pair(const audit::ExactPairRule& rule, int first, int second) {
  return {first, second, rule.decide(first, second)};
}

std::string text(const WhyPair& pair, const WhyScene& scene,
                 const audit::ExactPairRule& rule) {
  std::string out;
  for (const std::string& line :
       audit::story(rule, pair.first, pair.second, pair.decision))
    out += (out.empty() ? "" : "  ") + line + '\n';
  std::string unlisted;
  bool acted = false;
  each_record(scene.blocks, pair, [&](int corner, int edge) {
    const RememberedContact* contact = scene.find(corner, edge);
    const bool acts =
        std::binary_search(pair.decision.contacts.begin(), pair.decision.contacts.end(),
                           std::pair(corner, edge));
    const std::string name =
        fmt::format("{} on edge {} of block {}", audit::name_of(scene.blocks, corner),
                    number(scene.blocks, edge), scene.blocks.corner_block[edge] + 1);
    if (contact == nullptr && scene.listed && acts)
      unlisted += "  in the file: the list of potential contacts lacks " + name + '\n';
    if (contact == nullptr || !contact->active)
      return;
    acted = true;
    out += fmt::format("  in the file: {} acted in the step before: normal force "
                       "{:.6g}, shear force {:.6g}, overlap {:.6g}\n",
                       name, contact->normal_force, contact->shear_force,
                       contact->overlap);
  });
  if (!acted)
    out += "  in the file: no contact acted in the step before\n";
  return out + unlisted;
}

std::string json(const WhyPair& pair, const WhyScene& scene,
                 const audit::ExactPairRule& rule) {
  const Blocks& blocks = scene.blocks;
  Json contacts = Json::array(), before = Json::array(), parts = Json::array();
  for (const auto& [corner, edge] : pair.decision.contacts)
    contacts.push_back({{"corner", place(blocks, corner)},
                        {"block", blocks.corner_block[edge] + 1},
                        {"edge", number(blocks, edge)},
                        {"depth", rule.overlap(corner, edge)}});
  each_record(blocks, pair, [&](int corner, int edge) {
    const RememberedContact* contact = scene.find(corner, edge);
    if (contact != nullptr && contact->active)
      before.push_back({{"corner", place(blocks, corner)},
                        {"block", blocks.corner_block[edge] + 1},
                        {"edge", number(blocks, edge)},
                        {"normal_force", contact->normal_force},
                        {"shear_force", contact->shear_force},
                        {"overlap", contact->overlap}});
  });
  for (const audit::PartDecision& part : pair.decision.parts)
    parts.push_back({{"blocks", {pair.first + 1, pair.second + 1}},
                     {"choice", word(part.choice)},
                     {"axes", axes(rule, part)},
                     {"candidates", candidates(blocks, part)}});
  const Json all = {{"blocks", {pair.first + 1, pair.second + 1}},
                    {"time", scene.time},
                    {"step", scene.step},
                    {"contacts", contacts},
                    {"step_before", before},
                    {"parts", parts}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace blocks::apps
