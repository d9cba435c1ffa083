// The statistics as JSON.
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "post/read/units.hpp"
#include "report/tables.hpp"

namespace blocks::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr quantities::Dimension length{1, 0, 0, "m", ""};

Json number(double value) { return std::isfinite(value) ? Json(value + 0.0) : Json(); }

Json interval_json(const Interval& interval) {
  return {number(interval.low), number(interval.high)};
}

Json failure_json(const FailureCount& count) {
  return {{"failing", count.failing},
          {"stable", count.stable},
          {"undecided", count.undecided},
          {"share", number(count.share())},
          {"interval", interval_json(count.interval())}};
}

Json quantile_json(const Quantile& one) {
  return {{"value", number(one.value)}, {"interval", interval_json(one.interval)}};
}

Json seed_json(const Ensemble& ensemble, std::size_t row) {
  const auto& seed = ensemble.rows[row].seed;
  return seed ? Json(*seed) : Json();
}

Json summary_json(const Summary& s) {
  return {{"n", s.n},
          {"mean", number(s.mean)},
          {"interval", interval_json(s.mean_interval)},
          {"sd", number(s.standard_deviation)},
          {"p5", quantile_json(s.low)},
          {"p50", quantile_json(s.median)},
          {"p95", quantile_json(s.high)},
          {"min", number(s.min)},
          {"max", number(s.max)}};
}

Json column_json(const Ensemble& ensemble, std::size_t c, const ColumnStatistics& s) {
  const Column& column = ensemble.columns[c];
  Json json = {{"name", column.measure.name},
               {"label", column.label},
               {"unit", column.unit},
               {"missing", s.missing}};
  if (column.is_share) {
    json.update({{"n", s.summary.n},
                 {"share", number(s.summary.mean)},
                 {"interval", interval_json(s.interval)}});
    return json;
  }
  json.update(summary_json(s.summary));
  json["min_seed"] = s.summary.n > 0 ? seed_json(ensemble, s.min_row) : Json();
  json["max_seed"] = s.summary.n > 0 ? seed_json(ensemble, s.max_row) : Json();
  json["runs_needed"] = s.needed ? Json(*s.needed) : Json();
  return json;
}

Json numbers_json(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values)
    list.push_back(number(value));
  return list;
}

Json parameters_json(const Ensemble& ensemble, const Group& group) {
  Json json = Json::object();
  for (std::size_t p = 0; p < ensemble.parameters.size(); ++p)
    json[ensemble.parameters[p]] = group.values[p];
  return json;
}

Json group_json(const Ensemble& ensemble, const Analysis& analysis, std::size_t g) {
  const GroupStatistics& group = analysis.groups[g];
  Json outcomes = Json::object(), columns = Json::array();
  for (const OutcomeCount& one : group.outcomes) {
    outcomes[name_of(one.state)] = {{"count", one.count}};
    if (one.state != State::open)
      outcomes[name_of(one.state)]["interval"] = interval_json(one.share);
  }
  for (std::size_t c = 0; c < ensemble.columns.size(); ++c)
    columns.push_back(column_json(ensemble, c, group.columns[c]));
  Json json = {{"parameters", parameters_json(ensemble, ensemble.groups[g])},
               {"ended", group.ended},
               {"outcomes", outcomes},
               {"quantities", columns}};
  if (group.failure.total() > 0)
    json["factor_of_safety_below_1"] = failure_json(group.failure);
  if (group.differences) {
    Json list = Json::array();
    for (std::size_t c = 0; c < ensemble.columns.size(); ++c) {
      Json one = {{"name", ensemble.columns[c].measure.name}};
      one.update(summary_json(group.differences->columns[c]));
      list.push_back(std::move(one));
    }
    json["differences"] = {
        {"reference",
         parameters_json(ensemble, ensemble.groups[group.differences->reference])},
        {"quantities", list}};
  }
  if (group.profile)
    json["profile"] = {{"runs", group.profile->runs},
                       {"median", numbers_json(group.profile->median)},
                       {"p5", numbers_json(group.profile->low)},
                       {"p95", numbers_json(group.profile->high)}};
  return json;
}

Json indices_json(const SobolIndices& indices,
                  const std::vector<std::string>& parameters) {
  Json list = Json::array();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const SobolIndex& one = indices.parameters[i];
    list.push_back({{"parameter", parameters[i]},
                    {"first_order",
                     {{"value", number(one.first)},
                      {"interval", interval_json(one.first_interval)}}},
                    {"total",
                     {{"value", number(one.total)},
                      {"interval", interval_json(one.total_interval)}}}});
  }
  return {{"rows", indices.rows}, {"left_out", indices.left_out}, {"indices", list}};
}

Json sensitivities_json(const Ensemble& ensemble, const Analysis& analysis) {
  Json list = Json::array();
  for (const Sensitivity& one : analysis.sensitivities) {
    Json quantities = Json::array();
    for (std::size_t c = 0; c < ensemble.columns.size(); ++c) {
      Json quantity = {{"name", ensemble.columns[c].measure.name}};
      quantity.update(indices_json(one.quantities[c], one.parameters));
      quantities.push_back(std::move(quantity));
    }
    list.push_back({{"group", parameters_json(ensemble, ensemble.groups[one.group])},
                    {"quantities", quantities}});
  }
  return list;
}

}  // namespace

std::string statistics_json(const Ensemble& ensemble, const Analysis& analysis) {
  Json sweeps = Json::array(), groups = Json::array();
  for (const Member& member : ensemble.members)
    sweeps.push_back(
        {{"name", member.plan.name},
         {"deck", std::filesystem::path(member.plan.deck).filename().string()},
         {"deck_hash", member.plan.deck_hash},
         {"version", member.plan.version},
         {"numerics", member.plan.numerics},
         {"runs", member.plan.runs.size()}});
  for (std::size_t g = 0; g < ensemble.groups.size(); ++g)
    groups.push_back(group_json(ensemble, analysis, g));
  Json json = {{"blocks_report", 1},
               {"title", ensemble.title},
               {"sweeps", sweeps},
               {"confidence", confidence},
               {"precision", analysis.precision.words()}};
  if (ensemble.profile)
    json["profile"] = {{"line", ensemble.profile->line.segment ? "segment" : "top"},
                       {"quantity", ensemble.profile->quantity},
                       {"position_unit", post::unit_text(length, ensemble.units)},
                       {"position", numbers_json(ensemble.positions)}};
  if (!analysis.sensitivities.empty())
    json["sobol_indices"] = sensitivities_json(ensemble, analysis);
  json["groups"] = groups;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace blocks::report
