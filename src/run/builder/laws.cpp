// JOINT, WALTON, BARTON, JPAIR, BOND and DRIVE: the laws of joints and driven blocks
// (docs/laws.md).
#include "run/builder/builder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dynamics/preparation/bond.hpp"
#include "geometry/angle.hpp"
#include "model/drives.hpp"
#include "text/counted.hpp"

namespace blocks::run {

using deck::Command;

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

}  // namespace

void Builder::law_changed(const JointLaw& before, const JointLaw& after) {
  if (has_stiffness(before) || has_stiffness(after))
    model_.time_step.blocks = 0;
  model_.search.invalidate();
}

JointLaw* Builder::law(const Command& command, const deck::Int& id) {
  auto& laws = model_.settings.joint_laws;
  const auto found = laws.find(static_cast<int>(id.value));
  if (found != laws.end())
    return &found->second;
  if (unread_.may_define_joint(id.value))
    return nullptr;
  std::string known;
  for (const auto& [number, law] : laws)
    known += (known.empty() ? "" : ", ") + std::to_string(number);
  diagnostics_.error(id.where, command.name,
                     fmt::format("no JOINT card above has the id {}", id.value),
                     "joint ids with a JOINT card: " +
                         (known.empty() ? std::string("none") : known));
  return nullptr;
}

void Builder::define_joint(const Command& command, const deck::Joint& card) {
  const int id = static_cast<int>(card.id.value);
  const auto [met, is_new] =
      joints_.try_emplace(id, GivenAt{command.where.line, section_});
  if (!is_new && met->second.section == section_) {
    diagnostics_.error(card.id.where, command.name,
                       fmt::format("joint id {} is defined twice", id),
                       fmt::format("the first JOINT card is on line {}; only after a "
                                   "MOTION, CYCLE or SOLVE may another one replace it",
                                   met->second.line));
    return;
  }
  met->second = {command.where.line, section_};
  auto& laws = model_.settings.joint_laws;
  const JointLaw before = laws.contains(id) ? laws.at(id) : JointLaw();
  if (has_moved() && before.kind != LawKind::coulomb) {
    diagnostics_.error(
        card.id.where, command.name,
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
  law_changed(before, law);
}

JointLaw* Builder::law_to_extend(const Command& command, const deck::Int& id) {
  JointLaw* const found = law(command, id);
  if (found == nullptr)
    return nullptr;
  const auto refuse = [&](deck::SourceLocation where, const std::string& message,
                          const std::string& hint) {
    diagnostics_.error(where, command.name, message, hint);
    return nullptr;
  };
  if (has_moved())
    return refuse(command.where, "must come before the first MOTION, CYCLE or SOLVE",
                  after_motion_hint);
  if (found->kind != LawKind::coulomb)
    return refuse(id.where,
                  fmt::format("joint id {} has a {} card already", id.value,
                              name_of(found->kind)),
                  "a joint has one normal law: use another JOINT id");
  return found;
}

void Builder::define_walton(const Command& command, const deck::Walton& card) {
  JointLaw* const law = law_to_extend(command, card.id);
  if (law == nullptr)
    return;
  if (law->tension > 0.0 || law->dilation > 0.0) {
    diagnostics_.error(
        card.id.where, command.name,
        fmt::format("the JOINT card of id {} has {}", card.id.value,
                    law->tension > 0.0 ? "tensile strength" : "a dilation angle"),
        "Walton's law has neither: leave ten, tenr and dil blank");
    return;
  }
  const JointLaw before = *law;
  law->kind = LawKind::walton;
  law->restitution = card.e.value;
  law_changed(before, *law);
}

void Builder::define_barton(const Command& command, const deck::Barton& card) {
  JointLaw* const law = law_to_extend(command, card.id);
  if (law == nullptr)
    return;
  if (law->friction > 0.0 || law->cohesion > 0.0 || law->tension > 0.0 ||
      law->dilation > 0.0) {
    diagnostics_.error(
        card.id.where, command.name,
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
  law_changed(before, *law);
}

void Builder::pair_materials(const Command& command, const deck::Jpair& card) {
  const bool first = has_material(command, card.mat1);
  const bool second =
      card.mat2.value == card.mat1.value ? first : has_material(command, card.mat2);
  const JointLaw* const after = law(command, card.id);
  if (!first || !second || after == nullptr)
    return;
  const std::pair<int, int> pair =
      std::minmax(static_cast<int>(card.mat1.value), static_cast<int>(card.mat2.value));
  const auto [met, is_new] =
      pairs_.try_emplace(pair, GivenAt{command.where.line, section_});
  if (!is_new && met->second.section == section_) {
    diagnostics_.error(card.mat1.where, command.name,
                       fmt::format("materials {} and {} have a joint id already",
                                   card.mat1.value, card.mat2.value),
                       fmt::format("the first JPAIR card is on line {}; only after a "
                                   "MOTION, CYCLE or SOLVE may another one replace it",
                                   met->second.line));
    return;
  }
  met->second = {command.where.line, section_};
  auto& joints = model_.settings.joint_of_materials;
  const auto old = joints.find(pair);
  const JointLaw before =
      old == joints.end() ? JointLaw() : model_.settings.joint_laws.at(old->second);
  const bool keeps_kind =
      before.kind == LawKind::coulomb && after->kind == LawKind::coulomb;
  if (has_moved() && !keeps_kind && before != *after) {
    diagnostics_.error(
        card.id.where, command.name,
        fmt::format(
            "the law of a {} card cannot change after a MOTION "
            "or CYCLE",
            name_of(before.kind == LawKind::coulomb ? after->kind : before.kind)),
        after_motion_hint);
    return;
  }
  joints[pair] = static_cast<int>(card.id.value);
  law_changed(before, *after);
}

void Builder::bond(const Command& command, const deck::Bond& card) {
  const Settings& settings = model_.settings;
  const double ctol = settings.contact_tolerance;
  bool sound = true;
  const auto fault = [&](deck::SourceLocation where, const std::string& message,
                         const std::string& hint) {
    diagnostics_.error(where, command.name, message, hint);
    sound = false;
  };
  if (card.tol.given && card.tol.value > ctol)
    fault(card.tol.where,
          fmt::format("tol must not exceed ctol, found {:g} and {:g}", card.tol.value,
                      ctol),
          "blocks farther apart than ctol of BOXES may not be near each other");
  if (card.id.value == 0) {
    if (settings.joint_laws.empty() && !unread_.may_define_joint(0))
      fault(command.where, "no JOINT card above gives joints a law",
            "JOINT defines a law, JPAIR gives it to materials");
    sound = sound && !settings.joint_laws.empty();
  } else if (const JointLaw* const its_law = law(command, card.id)) {
    if (its_law->kind == LawKind::barton)
      fault(card.id.where,
            fmt::format("joint id {} has a BARTON card, so nothing can be bonded",
                        card.id.value),
            "Barton's law has no cohesion and no tensile strength");
  } else {
    sound = false;
  }
  if (!sound || !in_place_)
    return;
  constexpr double part_of_ctol = 0.01;
  const double tolerance = card.tol.given ? card.tol.value : part_of_ctol * ctol;
  const int bonded =
      dynamics::bond_faces(model_, static_cast<int>(card.id.value), tolerance);
  notes_.push_back(fmt::format("BOND in line {} at time {:g}: {} bonded",
                               command.where.line, model_.time,
                               counted(bonded, "contact")));
  // After an error the blocks or laws may be missing for that reason.
  if (bonded == 0 && !diagnostics_.has_errors())
    diagnostics_.warning(
        card.id.given ? card.id.where : command.where, command.name,
        fmt::format("no faces {} are flush within {:g}, so nothing is bonded",
                    card.id.value == 0 ? std::string("of joints with a law")
                                       : fmt::format("of joint id {}", card.id.value),
                    tolerance),
        place_hint(command));
}

bool Builder::can_drive(const Command& command, int b,
                        const deck::NumberOrSelector& named) {
  if (!model_.blocks.is_free(b))
    return can_move(command, b, named.where());
  // A FIX card with a fault may have named the block, and a selector may name others
  // when the run gets here.
  const bool is_certain =
      in_place_ ||
      (!perhaps_fixed_ && !(named.selector && named.selector->is_by_position()));
  if (!unread_.has("FIX") && is_certain)
    diagnostics_.error(
        named.where(), command.name,
        fmt::format("block {} is not fixed", missing_.number_of(b)),
        fmt::format("only fixed blocks can be driven: put FIX, {} before "
                    "this card, or use {} for a free block",
                    missing_.number_of(b),
                    command.name == "SERVO" ? "PRESSBC" : "SETVEL"));
  return false;
}

void Builder::drive(const Command& command, const deck::Drive& card) {
  const std::vector<int> chosen = blocks_named(command, card.nb);
  if (chosen.size() > 1 && card.tdot.value != 0.0) {
    error_several(command, card.nb, counted(chosen.size(), "block"));
    return;
  }
  for (const int b : chosen)
    if (can_drive(command, b, card.nb))
      drive_block(model_, {b, {card.vx.value, card.vy.value}, card.tdot.value});
}

}  // namespace blocks::run
