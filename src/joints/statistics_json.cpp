#include <cmath>
#include <nlohmann/json.hpp>

#include "joints/statistics.hpp"

namespace blocks::joints {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json json_of(const Estimate& one) {
  return {{"value", number(one.value)},
          {"low", number(one.low)},
          {"high", number(one.high)}};
}

ordered_json json_of(const TraceDensity& density) {
  return {{"p20", json_of(density.p20)},
          {"p21", json_of(density.p21)},
          {"mean_length_by_ends", json_of(density.by_ends)},
          {"mean_length_by_counts", json_of(density.by_counts)}};
}

ordered_json json_of(const FittedLaw& fitted) {
  ordered_json json = {{"mean", json_of(fitted.mean)},
                       {"log_likelihood", number(fitted.log_likelihood)},
                       {"aic", number(fitted.aic())}};
  if (fitted.law.form == LengthForm::lognormal)
    json["deviation_of_logarithm"] =
        number(std::isfinite(fitted.log_likelihood) ? fitted.law.spread : unknown);
  return json;
}

ordered_json json_of(const SpacingStatistics& one) {
  return {{"length", number(one.length)},      {"crossings", one.crossings},
          {"p10", number(one.frequency)},      {"p10_corrected", number(one.corrected)},
          {"spacings", one.spacings},          {"mean_spacing", number(one.mean)},
          {"variation", number(one.variation)}};
}

ordered_json json_of(const FamilyStatistics& one) {
  return {
      {"scattered", one.scattered},
      {"direction", one.scattered ? ordered_json(nullptr) : number(one.family.mean)},
      {"kappa", one.family.kappa},
      {"weight", one.family.weight},
      {"deviation", number(one.deviation)},
      {"parts", one.pieces},
      {"share_of_length", one.share},
      {"density", json_of(one.density)},
      {"spacing", json_of(one.spacing)}};
}

ordered_json json_of(const MapStatistics& map) {
  const Network& network = map.network;
  const NodeCounts& nodes = network.nodes;
  const Topology& t = map.topology;
  ordered_json hidden = {0, 0, 0};
  for (const Piece& piece : network.pieces)
    hidden[static_cast<std::size_t>(piece.hidden)] =
        hidden[static_cast<std::size_t>(piece.hidden)].get<int>() + 1;
  ordered_json json = {{"name", map.name},
                       {"area", network.area},
                       {"shortest", map.shortest},
                       {"length", network.length()},
                       {"overshoots_cut", network.overshoots},
                       {"overlapping_ends", network.overlaps},
                       {"nodes",
                        {{"i", nodes.i},
                         {"y", nodes.y},
                         {"x", nodes.x},
                         {"more_than_four", nodes.more},
                         {"joined_ends", nodes.joined},
                         {"e", nodes.window}}},
                       {"branches",
                        {{"number", t.branches},
                         {"c_c", t.cc},
                         {"c_i", t.ci},
                         {"i_i", t.ii},
                         {"cut_by_window", t.at_window},
                         {"mean_length", number(t.mean_branch)},
                         {"b20", number(t.branch_density)},
                         {"b22", number(t.branch_intensity)},
                         {"connections_per_branch", number(t.connections_per_branch)}}},
                       {"traces",
                        {{"number", t.lines},
                         {"parts", network.pieces.size()},
                         {"parts_by_hidden_ends", hidden},
                         {"connections_per_trace", number(t.connections_per_line)},
                         {"density", json_of(map.density)},
                         {"exponential", json_of(map.exponential)},
                         {"lognormal", json_of(map.lognormal)}}},
                       {"components_by_bic", map.mixture.components}};
  json["families"] = ordered_json::array();
  for (const FamilyStatistics& one : map.families)
    json["families"].push_back(json_of(one));
  json["scanlines"] = {{"along_x", json_of(map.along_x)},
                       {"along_y", json_of(map.along_y)}};
  json["scanlines"]["given"] = ordered_json::array();
  for (const SpacingStatistics& one : map.scanlines)
    json["scanlines"]["given"].push_back(json_of(one));
  return json;
}

}  // namespace

std::string statistics_json(const std::vector<MapStatistics>& maps) {
  ordered_json all = {{"maps", ordered_json::array()}};
  for (const MapStatistics& map : maps)
    all["maps"].push_back(json_of(map));
  return all.dump(2) + "\n";
}

}  // namespace blocks::joints
