// JOINT, WALTON, BARTON, JPAIR and BOND: the laws of joints (docs/laws.md).
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "dynamics/preparation/bond.hpp"
#include "geometry/angle.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/names.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

constexpr const char* after_motion_hint =
    "the kind of a law cannot change once blocks have moved: put the card before the "
    "first MOTION, CYCLE or SOLVE";

const char* name_of(LawKind kind) {
  return kind == LawKind::walton ? "WALTON" : "BARTON";
}

/// Whether the time step depends on the law.
bool has_stiffness(const JointLaw& law) {
  return law.normal_stiffness > 0.0 || law.shear_stiffness > 0.0 ||
         law.kind != LawKind::coulomb;
}

/// Demands a new time step if one of the laws has a stiffness of its own.
void law_changed(const Context& context, const JointLaw& before,
                 const JointLaw& after) {
  if (has_stiffness(before) || has_stiffness(after))
    context.model.time_step.blocks = 0;
  context.model.search.invalidate();
}

/// Returns the law of this joint id. Reports an error and returns null if no JOINT card
/// defines it.
JointLaw* find_law(const Context& context, const deck::Int& id) {
  auto& laws = context.settings.joint_laws;
  const auto found = laws.find(static_cast<int>(id.value));
  if (found != laws.end())
    return &found->second;
  if (context.state.unread.may_define_joint(id.value))
    return nullptr;
  context.error(id.where, fmt::format("no JOINT card above has the id {}", id.value),
                "joint ids with a JOINT card: " + listed(laws));
  return nullptr;
}

/// Records the place of a card that defines `key`. Reports an error if another one of
/// this section has defined it.
template <class Key>
bool define(const Context& context, std::map<Key, BuilderState::GivenAt>& given,
            const Key& key, deck::SourceLocation where, const std::string& problem) {
  const BuilderState::GivenAt here{context.command.where.line, context.state.section};
  const auto [met, is_new] = given.try_emplace(key, here);
  if (!is_new && met->second.section == here.section) {
    context.error(where, problem,
                  fmt::format("the first {} card is on line {}; only after a MOTION, "
                              "CYCLE or SOLVE may another one replace it",
                              context.command.name, met->second.line));
    return false;
  }
  met->second = here;
  return true;
}

/// Returns the law that WALTON or BARTON extends, or null after an error.
JointLaw* law_to_extend(const Context& context, const deck::Int& id) {
  JointLaw* const found = find_law(context, id);
  if (found == nullptr)
    return nullptr;
  const auto refuse = [&](deck::SourceLocation where, const std::string& message,
                          const std::string& hint) {
    context.error(where, message, hint);
    return nullptr;
  };
  if (context.has_moved())
    return refuse(context.command.where,
                  "must come before the first MOTION, CYCLE or SOLVE",
                  after_motion_hint);
  if (found->kind != LawKind::coulomb)
    return refuse(id.where,
                  fmt::format("joint id {} has a {} card already", id.value,
                              name_of(found->kind)),
                  "a joint has one normal law: use another JOINT id");
  return found;
}

}  // namespace

void act(const Context& context, const deck::Joint& card) {
  const int id = static_cast<int>(card.id.value);
  if (!define(context, context.state.joints, id, card.id.where,
              fmt::format("joint id {} is defined twice", id)))
    return;
  auto& laws = context.settings.joint_laws;
  const JointLaw before = laws.contains(id) ? laws.at(id) : JointLaw();
  if (context.has_moved() && before.kind != LawKind::coulomb) {
    context.error(
        card.id.where,
        fmt::format("joint id {} has a {} card, so its values cannot change", id,
                    name_of(before.kind)),
        "after a MOTION, CYCLE or SOLVE, JOINT changes only joints without WALTON or "
        "BARTON");
    return;
  }
  JointLaw& law = laws[id] = {};
  law.friction = card.fric.value;
  law.cohesion = card.coh.value;
  law.tension = card.ten.value;
  law.residual_friction = card.fricr.value;
  law.residual_cohesion = card.cohr.value;
  law.residual_tension = card.tenr.value;
  law.dilation = geometry::tangent_of_degrees(card.dil.value);
  if (card.zdil.given)
    law.dilation_limit = card.zdil.value;
  law.normal_stiffness = card.kn.value;
  law.shear_stiffness = card.ks.value;
  law_changed(context, before, law);
}

void act(const Context& context, const deck::Walton& card) {
  JointLaw* const law = law_to_extend(context, card.id);
  if (law == nullptr)
    return;
  if (law->tension > 0.0 || law->dilation > 0.0) {
    context.error(
        card.id.where,
        fmt::format("the JOINT card of id {} has {}", card.id.value,
                    law->tension > 0.0 ? "tensile strength" : "a dilation angle"),
        "Walton's law has neither: leave ten, tenr and dil blank");
    return;
  }
  const JointLaw before = *law;
  law->kind = LawKind::walton;
  law->restitution = card.e.value;
  law_changed(context, before, *law);
}

void act(const Context& context, const deck::Barton& card) {
  JointLaw* const law = law_to_extend(context, card.id);
  if (law == nullptr)
    return;
  if (law->friction > 0.0 || law->cohesion > 0.0 || law->tension > 0.0 ||
      law->dilation > 0.0) {
    context.error(
        card.id.where,
        fmt::format("the JOINT card of id {} has {}", card.id.value,
                    law->cohesion > 0.0   ? "cohesion"
                    : law->tension > 0.0  ? "tensile strength"
                    : law->friction > 0.0 ? "friction"
                                          : "a dilation angle"),
        "BARTON gives the strength and the dilation: leave fric, coh, ten, dil and the "
        "residual values blank");
    return;
  }
  const JointLaw before = *law;
  law->kind = LawKind::barton;
  law->roughness = card.jrc.value;
  law->wall_strength = card.jcs.value;
  law->residual_angle = card.phir.value;
  law->peak_slip = card.upeak.value;
  law->initial_stiffness = card.kni.value;
  law->largest_closure = card.vm.value;
  law->largest_stiffness = card.knmax.value;
  law_changed(context, before, *law);
}

void act(const Context& context, const deck::Jpair& card) {
  const bool first = has_material(context, card.mat1);
  const bool second =
      card.mat2.value == card.mat1.value ? first : has_material(context, card.mat2);
  const JointLaw* const after = find_law(context, card.id);
  if (!first || !second || after == nullptr)
    return;
  const std::pair<int, int> pair =
      std::minmax(static_cast<int>(card.mat1.value), static_cast<int>(card.mat2.value));
  if (!define(context, context.state.pairs, pair, card.mat1.where,
              fmt::format("materials {} and {} have a joint id already",
                          card.mat1.value, card.mat2.value)))
    return;
  auto& joints = context.settings.joint_of_materials;
  const auto old = joints.find(pair);
  const JointLaw before =
      old == joints.end() ? JointLaw() : context.settings.joint_laws.at(old->second);
  const bool keeps_kind =
      before.kind == LawKind::coulomb && after->kind == LawKind::coulomb;
  if (context.has_moved() && !keeps_kind && before != *after) {
    context.error(card.id.where,
                  fmt::format("the law of a {} card cannot change after a MOTION "
                              "or CYCLE",
                              name_of(before.kind == LawKind::coulomb ? after->kind
                                                                      : before.kind)),
                  after_motion_hint);
    return;
  }
  joints[pair] = static_cast<int>(card.id.value);
  law_changed(context, before, *after);
}

void act(const Context& context, const deck::Bond& card) {
  const Settings& settings = context.settings;
  const double ctol = settings.contact_tolerance;
  bool sound = true;
  const auto fault = [&](deck::SourceLocation where, const std::string& message,
                         const std::string& hint) {
    context.error(where, message, hint);
    sound = false;
  };
  if (card.tol.given && card.tol.value > ctol)
    fault(card.tol.where,
          fmt::format("tol must not exceed ctol, found {:g} and {:g}", card.tol.value,
                      ctol),
          "blocks farther apart than ctol of BOXES may not be near each other");
  if (card.id.value == 0) {
    if (settings.joint_laws.empty() && !context.state.unread.may_define_joint(0))
      fault(context.command.where, "no JOINT card above gives joints a law",
            "JOINT defines a law, JPAIR gives it to materials");
    sound = sound && !settings.joint_laws.empty();
  } else if (const JointLaw* const its_law = find_law(context, card.id)) {
    if (its_law->kind == LawKind::barton)
      fault(card.id.where,
            fmt::format("joint id {} has a BARTON card, so nothing can be bonded",
                        card.id.value),
            "Barton's law has no cohesion and no tensile strength");
  } else {
    sound = false;
  }
  if (!sound || !context.state.in_place)
    return;
  constexpr double part_of_ctol = 0.01;
  const double tolerance = card.tol.given ? card.tol.value : part_of_ctol * ctol;
  const int bonded =
      dynamics::bond_faces(context.model, static_cast<int>(card.id.value), tolerance);
  context.note(counted(bonded, "contact") + " bonded");
  // After an error the blocks or laws may be missing for that reason.
  if (bonded == 0 && !context.diagnostics.has_errors())
    context.warning(
        card.id.given ? card.id.where : context.command.where,
        fmt::format("no faces {} are flush within {:g}, so nothing is bonded",
                    card.id.value == 0 ? std::string("of joints with a law")
                                       : fmt::format("of joint id {}", card.id.value),
                    tolerance),
        place_hint(context));
}

}  // namespace blocks::run
