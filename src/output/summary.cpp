#include "output/summary.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "files/file_tools.hpp"
#include "files/fnv1a.hpp"
#include "model/drives.hpp"
#include "model/words/certificate_text.hpp"
#include "model/words/crack_report.hpp"
#include "output/cuts_json.hpp"
#include "quantities/energy.hpp"

namespace blocks::output {
namespace {

using Json = nlohmann::ordered_json;

Json vector(const Vec2& v) { return {v.x(), v.y()}; }

/// The number (from 1) and the speed of the fastest block; null without blocks.
Json fastest_block(const Blocks& blocks) {
  int fastest = -1;
  double speed = -1.0;
  for (int b = 0; b < blocks.size(); ++b)
    if (const double v = blocks.velocity.col(b).norm(); v > speed) {
      fastest = b;
      speed = v;
    }
  return fastest < 0 ? Json() : Json{{"block", fastest + 1}, {"speed", speed}};
}

/// The servos: target and stress of their sides, and their speed along the normal.
Json servos(const Model& model) {
  Json list = Json::array();
  for (const Servo& servo : model.servos) {
    const Vec2 outwards = side_of(model.blocks, servo).outwards;
    list.push_back({{"block", servo.block + 1},
                    {"side", servo.side + 1},
                    {"target", servo.target},
                    {"stress", stress_on(model, servo)},
                    {"speed", outwards.dot(model.blocks.velocity.col(servo.block))}});
  }
  return list;
}

Json layers(const Model& model) {
  Json list = Json::array();
  for (const LayerRecord& layer : model.layers)
    list.push_back({{"layer", layer.number},
                    {"first_block", layer.first_block + 1},
                    {"blocks", layer.blocks},
                    {"certificate",
                     {{"cells", layer.cells},
                      {"interior_edges", layer.interior_edges},
                      {"outline_edges", layer.outline_edges}}},
                    {"angles_redrawn", layer.redrawn},
                    {"sides_redrawn", layer.redrawn_sides},
                    {"sides_ruled", layer.ruled}});
  return list;
}

/// The first pairs. The certificate also holds the number of all pairs.
Json pairs(const std::vector<geometry::BlockOverlap>& overlaps) {
  Json list = Json::array();
  for (std::size_t i = 0; i < std::min(overlaps.size(), max_pairs_named); ++i)
    list.push_back({{"blocks", {overlaps[i].first + 1, overlaps[i].second + 1}},
                    {"area", overlaps[i].area},
                    {"place", vector(overlaps[i].place)}});
  return list;
}

Json gaps(const AssemblyCertificate& proof) {
  Json list = Json::array();
  for (std::size_t i = 0; i < std::min(proof.gaps(), max_pairs_named); ++i) {
    const geometry::Slit& slit = proof.joints.slits[i];
    list.push_back({{"blocks", {slit.first + 1, slit.second + 1}},
                    {"width", slit.width},
                    {"place", vector(slit.place)}});
  }
  return list;
}

/// The certificate as JSON; null for a model without blocks.
Json certificate(const SharedCertificate& proof) {
  if (!proof)
    return nullptr;
  double largest = 0.0;
  for (const auto& pair : proof->overlaps)
    largest = std::max(largest, pair.area);
  return {{"holds", proof->holds()},
          {"verdict", verdict(*proof)},
          {"blocks", proof->blocks - proof->removed},
          {"moved_blocks", proof->moved},
          {"overlapping_pairs", proof->overlaps.size()},
          {"largest_overlap_area", largest},
          {"overlaps", pairs(proof->overlaps)},
          {"rounding_pairs", proof->roundings.size()},
          {"roundings", pairs(proof->roundings)},
          {"contact_pairs", proof->contacts.size()},
          {"contacts", pairs(proof->contacts)},
          {"gap_count", proof->gaps()},
          {"widest_gap", proof->gaps() > 0 ? proof->joints.slits.front().width : 0.0},
          {"gaps", gaps(*proof)},
          {"slits_by_rounding", proof->rounding_slits},
          {"t_junction_count", proof->t_junctions}};
}

Json audited(const AuditedOverlap& pair) {
  return {{"blocks", {pair.first + 1, pair.second + 1}},
          {"step", pair.step},
          {"time", pair.time},
          {"excess", pair.excess()},
          {"overlap", pair.depth},
          {"deepest_contact", pair.explained},
          {"springs_pressed_in", pair.pressed}};
}

Json audited(const AuditedContact& contact) {
  return {{"corner", {contact.block + 1, contact.corner + 1}},
          {"edge", {contact.edge_block + 1, contact.edge + 1}},
          {"step", contact.step},
          {"time", contact.time},
          {"excess", contact.excess()},
          {"contact_overlap", contact.overlap},
          {"common_depth", contact.common},
          {"spring_pressed_in", contact.pressed}};
}

Json audited(const AuditedWater& water) {
  return {{"block", water.block + 1},
          {"step", water.step},
          {"time", water.time},
          {"error", water.share}};
}
Json audited(const AuditedPlane& corner) {
  return {
      {"plane", corner.plane + 1}, {"corner", {corner.block + 1, corner.corner + 1}},
      {"step", corner.step},       {"time", corner.time},
      {"depth", corner.depth},     {"spring_pressed_in", corner.pressed}};
}

/// The ten worst findings.
template <class Found> Json worst_of(std::vector<Found> found) {
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.excess() > b.excess(); });
  found.resize(std::min<std::size_t>(found.size(), 10));
  Json list = Json::array();
  for (const Found& one : found)
    list.push_back(audited(one));
  return list;
}

/// Counts, messages of faults, and the ten worst overlaps and contacts; null without
/// audit.
Json audit(const std::optional<AuditTotals>& totals) {
  if (!totals)
    return nullptr;
  return {
      {"every", totals->every},
      {"moments", totals->moments},
      {"pairs", totals->pairs},
      {"acting", totals->acting},
      {"missed_pairs", totals->missed},
      {"wrong_decisions", totals->wrong},
      {"wrong_at_planes", totals->wrong_at_planes},
      {"late_decisions", totals->late},
      {"excess_pairs", totals->excess.size()},
      {"worst_excess", totals->worst.excess() > 0.0 ? audited(totals->worst) : Json()},
      {"deep_contacts", totals->deep.size()},
      {"worst_deep_contact",
       totals->deepest.excess() > 0.0 ? audited(totals->deepest) : Json()},
      {"deepest_behind_plane",
       totals->behind.depth > 0.0 ? audited(totals->behind) : Json()},
      {"worst_water", totals->water.tested ? audited(totals->water) : Json()},
      {"faults", totals->faults},
      {"excess_overlaps", worst_of(totals->excess)},
      {"deepest_contacts", worst_of(totals->deep)}};
}

/// The cracks in the order in which blocks split.
Json cracks(const Model& model) {
  Json list = Json::array();
  for (const CrackRecord& crack : model.cracks)
    list.push_back({{"step", crack.step},
                    {"time", crack.time},
                    {"parent", crack.parent + 1},
                    {"child", crack.child + 1},
                    {"cause", describe(crack.cause)},
                    {"stress", crack.stress},
                    {"angle", crack.angle()},
                    {"from", vector(crack.from)},
                    {"to", vector(crack.to)},
                    {"moved", crack.moved},
                    {"areas", {crack.parent_area, crack.child_area}},
                    {"kinetic", {crack.kinetic_before, crack.kinetic_after}},
                    {"strain", {crack.strain_before, crack.strain_after}},
                    {"released", crack.released()}});
  return list;
}

/// The numbers of cracks by cause.
Json crack_counts(const Model& model) {
  const auto by = [&](CrackCause cause) {
    return std::count_if(
        model.cracks.begin(), model.cracks.end(),
        [&](const CrackRecord& crack) { return crack.cause == cause; });
  };
  return {{"all", model.cracks.size()},
          {"stress", by(CrackCause::stress)},
          {"point loads", by(CrackCause::point_loads)}};
}

/// The numbers, from 1, of the blocks that reached their strength but did not split, by
/// reason.
Json refused_cracks(const Model& model) {
  Json by_reason = Json::object();
  for (int i = 0; i < crack_refusals; ++i) {
    const auto why = static_cast<CrackRefusal>(i);
    if (count_refused(model.crack_refusals, why) == 0)
      continue;
    Json& blocks = by_reason[describe(why)] = Json::array();
    for (const RefusedCrack& refused : model.crack_refusals)
      if (refused.why == why)
        blocks.push_back(refused.block + 1);
  }
  return by_reason;
}

Json exits(const Model& model) {
  Json list = Json::array();
  for (const DomainExit& exit : model.exits)
    list.push_back({{"block", exit.block + 1}, {"time", exit.time}});
  return list;
}

bool is_scaled(const SolveRecord& solve) {
  return solve.min_scale != 1.0 || solve.largest_scale != 1.0;
}

Json solves(const Model& model) {
  Json list = Json::array();
  for (const SolveRecord& solve : model.solves)
    list.push_back(
        {{"line", solve.line},
         {"ratio", solve.wanted},
         {"reached", solve.reached},
         {"converged", solve.converged},
         {"steps", solve.steps},
         {"time", solve.time},
         {"local", solve.wanted_local},
         {"reached_local", solve.reached_local},
         {"local_block", solve.local_block < 0 ? Json() : Json(solve.local_block + 1)},
         {"time_step", solve.dt},
         {"mass_scaling", is_scaled(solve) ? Json{{"least", solve.min_scale},
                                                  {"largest", solve.largest_scale}}
                                           : Json()},
         {"largest_unbalanced", solve.block < 0 ? Json()
                                                : Json{{"block", solve.block + 1},
                                                       {"force", solve.largest}}}});
  return list;
}

Json trial_json(const SafetyTrial& trial) {
  return {{"factor", trial.factor},
          {"outcome", describe(trial.outcome)},
          {"steps", trial.steps},
          {"ratio", trial.ratio},
          {"local", trial.local},
          {"fastest_block", trial.block < 0 ? Json() : Json(trial.block + 1)},
          {"speed", trial.speed},
          {"moved", trial.moved}};
}

/// The result of one FOS card. A missing end of its bracket is null.
Json factor_of_safety(const Model& model, std::size_t search) {
  const SafetyFactor& card = model.safety_factors[search];
  const std::vector<SafetyTrial> trials =
      trials_of(model.safety_trials, static_cast<int>(search));
  Json list = Json::array();
  for (const SafetyTrial& trial : trials)
    list.push_back(trial_json(trial));
  const SafetyBracket bracket = bracket_of(trials);
  return {{"line", card.line},
          {"lower", bracket.stable ? Json(*bracket.stable) : Json()},
          {"upper", bracket.failing ? Json(*bracket.failing) : Json()},
          {"width", card.width},
          {"complete", card.complete},
          {"response_steps", card.response},
          {"most_steps", card.max_steps},
          {"trials", list}};
}

bool all_converged(const std::vector<SolveRecord>& solves) {
  return std::all_of(solves.begin(), solves.end(),
                     [](const SolveRecord& solve) { return solve.converged; });
}

}  // namespace

std::string state_hash(const Model& model) {
  const Blocks& blocks = model.blocks;
  files::Fnv1a hash;
  const auto add = [&](const auto& matrix) {
    hash.add(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(double));
  };
  add(blocks.corner);
  add(blocks.centroid);
  add(blocks.angle);
  add(blocks.velocity);
  add(blocks.spin);
  return hash.text();
}

void write_summary(const std::string& path, const Model& model,
                   const RunReport& report) {
  const ModelTotals sums = totals(model);
  Json json = {
      {"title", report.identity.title},
      {"deck", report.identity.deck_file},
      {"version", report.identity.version},
      {"seed", report.identity.seed},
      {"status", report.status},
      {"steps", model.steps},
      {"time", model.time},
      {"dt",
       {{"value", model.time_step.dt},
        {"block", model.time_step.block < 0 ? Json() : Json(model.time_step.block + 1)},
        {"limit", model.time_step.block < 0 ? Json()
                  : model.time_step.elastic ? Json("elasticity")
                                            : Json("contact")}}},
      {"blocks", model.blocks.size()},
      {"corners", model.blocks.corners()},
      {"contacts",
       {{"listed", sums.listed_contacts}, {"active", sums.active_contacts}}},
      {"list_updates", model.search.updates},
      {"kinetic_energy", sums.kinetic_energy},
      {"momentum", vector(sums.momentum)},
      {"angular_momentum", sums.angular_momentum},
      {"worst_overlap", {{"end", sums.worst_overlap}, {"ever", model.worst_overlap}}},
      {"fastest_block", fastest_block(model.blocks)},
      {"domain_exits", exits(model)},
      {"merges", merges_json(model.merges)},
      {"layers", layers(model)},
      {"certificate", certificate(report.certificate)},
      {"audit", audit(report.audit)},
      {"warnings", report.warnings},
      {"frames", report.frames},
      {"state_hash", state_hash(model)},
      {"wall_seconds", report.wall_seconds}};

  if (report.solved || !model.solves.empty()) {
    json["converged"] = report.solved.value_or(true) && all_converged(model.solves);
    json["solves"] = solves(model);
  }
  if (!model.safety_factors.empty())
    json["factor_of_safety"] = factor_of_safety(model, model.safety_factors.size() - 1);
  if (model.safety_factors.size() > 1)
    for (std::size_t i = 0; i < model.safety_factors.size(); ++i)
      json["factors_of_safety"].push_back(factor_of_safety(model, i));
  if (model.energy.kept)
    for (const quantities::EnergyQuantity& one : quantities::energy_quantities())
      json["energy"][one.name] = one.value(model.energy);
  if (!model.settings.joint_laws.empty())
    json["joint_contacts"] = {{"with_law", sums.with_law},
                              {"bonded", sums.bonded},
                              {"failed", sums.failed},
                              {"broken", sums.broken}};
  if (model.time_step.pieces)
    json["dt"]["pieces"] = true;
  if (!model.settings.crack_rules.empty() || !model.cracks.empty()) {
    json["crack_counts"] = crack_counts(model);
    json["cracks"] = cracks(model);
    json["refused_cracks"] = refused_cracks(model);
  }
  if (!model.servos.empty())
    json["servos"] = servos(model);
  if (!model.cuts.empty())
    json["cuts"] = cuts_json(model.cuts, model.joint_lengths);
  if (const int present = model.blocks.count_present(); present < model.blocks.size())
    json["removed_blocks"] = model.blocks.size() - present;

  // A title may contain any bytes. Numbers that are not finite become null.
  files::replace_file(path,
                      json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace blocks::output
