#include "report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "post/units.hpp"

namespace blocks::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr quantities::Dimension length{1, 0, 0, "m", ""};

/// Quotes a text that contains a comma, a quote or a line break (RFC 4180).
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string safe = "\"";
  for (const char c : text)
    safe += c == '"' ? "\"\"" : std::string(1, c);
  return safe + '"';
}

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value + 0.0) : "";
}

std::string seed_cell(const Ensemble& ensemble, std::size_t row) {
  const auto& seed = ensemble.rows[row].seed;
  return seed ? std::to_string(*seed) : "";
}

/// The columns after the parameters.
constexpr const char* statistics_head =
    "kind,name,unit,n,missing,count,mean,mean_low,mean_high,interval,sd,"
    "p5,p5_low,p5_high,p50,p50_low,p50_high,p95,p95_low,p95_high,"
    "min,min_seed,max,max_seed,runs_needed,reference\n";

/// Adds cells from p5 to p95.
void add_quantiles(std::string& line, const Summary& summary) {
  for (const Quantile* one : {&summary.low, &summary.median, &summary.high})
    line += ',' + cell(one->value) + ',' + cell(one->interval.low) + ',' +
            cell(one->interval.high);
}

std::string outcome_row(const OutcomeCount& one, std::size_t ended) {
  const bool open = one.state == State::open;
  const double share =
      open || ended == 0 ? no_number
                         : static_cast<double>(one.count) / static_cast<double>(ended);
  std::string line =
      fmt::format("outcome,{},,{},,{},{},{},{},{}", name_of(one.state),
                  open ? std::string() : std::to_string(ended), one.count, cell(share),
                  cell(one.share.low), cell(one.share.high), open ? "" : "wilson");
  return line + std::string(16, ',') + '\n';
}

std::string quantity_row(const Ensemble& ensemble, const Column& column,
                         const ColumnStatistics& found) {
  const Summary& s = found.summary;
  const double hits = s.mean * static_cast<double>(s.n);
  std::string line =
      fmt::format("quantity,{},{},{},{},{},{},{},{},{},{}", quoted(column.measure.name),
                  quoted(column.unit), s.n, found.missing,
                  column.is_share && s.n > 0 ? std::to_string(std::lround(hits)) : "",
                  cell(s.mean), cell(found.interval.low), cell(found.interval.high),
                  column.is_share ? "wilson" : "t", cell(s.standard_deviation));
  if (column.is_share) {
    line += std::string(15, ',');
  } else {
    add_quantiles(line, s);
    line +=
        fmt::format(",{},{},{},{},{},", cell(s.least),
                    s.n > 0 ? seed_cell(ensemble, found.least_row) : "", cell(s.most),
                    s.n > 0 ? seed_cell(ensemble, found.most_row) : "",
                    found.needed ? std::to_string(*found.needed) : "");
  }
  return line + '\n';
}

std::string difference_row(const Ensemble& ensemble, const Column& column,
                           const Summary& s, std::size_t reference) {
  std::string line =
      fmt::format("difference,{},{},{},,,{},{},{},t,{}", quoted(column.measure.name),
                  quoted(column.unit), s.n, cell(s.mean), cell(s.mean_interval.low),
                  cell(s.mean_interval.high), cell(s.standard_deviation));
  add_quantiles(line, s);
  return line + fmt::format(",{},,{},,,{}\n", cell(s.least), cell(s.most),
                            quoted(ensemble.name_of(ensemble.groups[reference])));
}

Json number(double value) { return std::isfinite(value) ? Json(value + 0.0) : Json(); }

Json interval_json(const Interval& interval) {
  return {number(interval.low), number(interval.high)};
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
          {"min", number(s.least)},
          {"max", number(s.most)}};
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
  json["min_seed"] = s.summary.n > 0 ? seed_json(ensemble, s.least_row) : Json();
  json["max_seed"] = s.summary.n > 0 ? seed_json(ensemble, s.most_row) : Json();
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

/// Returns the width on a terminal: the number of bytes that begin a character.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::size_t own = width_of(text);
  const std::string space(own < width ? width - own : 0, ' ');
  return right ? space + text : text + space;
}

std::string short_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value + 0.0) : "-";
}

std::string short_interval(const Interval& interval) {
  return std::isfinite(interval.low)
             ? short_number(interval.low) + " to " + short_number(interval.high)
             : "-";
}

/// Returns the rows as a table; the first column is aligned to the left.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c)
      widths[c] = std::max(widths[c], width_of(row[c]));
  std::string text;
  for (const auto& row : rows) {
    std::string line = "  ";
    for (std::size_t c = 0; c < row.size(); ++c)
      line += padded(row[c], widths[c], c > 0) + (c + 1 < row.size() ? "  " : "");
    text += line + '\n';
  }
  return text;
}

}  // namespace

std::string statistics_csv(const Ensemble& ensemble, const Analysis& analysis) {
  std::string text;
  for (const std::string& parameter : ensemble.parameters)
    text += quoted(parameter) + ',';
  text += statistics_head;
  for (std::size_t g = 0; g < ensemble.groups.size(); ++g) {
    std::string begin;
    for (const std::string& value : ensemble.groups[g].values)
      begin += quoted(value) + ',';
    const GroupStatistics& group = analysis.groups[g];
    for (const OutcomeCount& one : group.outcomes)
      text += begin + outcome_row(one, group.ended);
    for (std::size_t c = 0; c < ensemble.columns.size(); ++c)
      text += begin + quantity_row(ensemble, ensemble.columns[c], group.columns[c]);
    if (group.differences)
      for (std::size_t c = 0; c < ensemble.columns.size(); ++c)
        text += begin + difference_row(ensemble, ensemble.columns[c],
                                       group.differences->columns[c],
                                       group.differences->reference);
  }
  return text;
}

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
  json["groups"] = groups;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string runs_csv(const Ensemble& ensemble) {
  const bool several = ensemble.members.size() > 1 &&
                       std::find(ensemble.parameters.begin(), ensemble.parameters.end(),
                                 "sweep") == ensemble.parameters.end();
  std::string text = several ? "sweep,run," : "run,";
  for (const std::string& parameter : ensemble.parameters)
    text += quoted(parameter) + ',';
  text += "seed,outcome,code,status,message";
  for (const Column& column : ensemble.columns)
    text += ',' + quoted(column.measure.name);
  text += '\n';
  for (const RunRow& row : ensemble.rows) {
    if (several)
      text += quoted(ensemble.members[row.member].label) + ',';
    text += std::to_string(row.id) + ',';
    for (const std::string& value : ensemble.groups[row.group].values)
      text += quoted(value) + ',';
    text += fmt::format("{},{},{},{},{}", row.seed ? std::to_string(*row.seed) : "",
                        name_of(row.state), row.code ? std::to_string(*row.code) : "",
                        quoted(row.status), quoted(portable_message(ensemble, row)));
    for (const double value : row.values)
      text += ',' + cell(value);
    text += '\n';
  }
  return text;
}

std::string statistics_text(const Ensemble& ensemble, const Analysis& analysis) {
  std::string text = ensemble.title.empty() ? "" : ensemble.title + '\n';
  text += sweep_words(ensemble) + '\n';
  constexpr std::size_t most_groups = 20;
  for (std::size_t g = 0; g < std::min(ensemble.groups.size(), most_groups); ++g) {
    const GroupStatistics& group = analysis.groups[g];
    const std::string name = ensemble.name_of(ensemble.groups[g]);
    text +=
        fmt::format("\n{}{}{}\n", name, name.empty() ? "" : ": ", outcome_words(group));
    std::vector<std::vector<std::string>> rows = {
        {"", "unit", "n", "mean", "95 % interval", "sd", "5 %", "median", "95 %",
         "runs for " + analysis.precision.words()}};
    for (std::size_t c = 0; c < ensemble.columns.size(); ++c) {
      const Column& column = ensemble.columns[c];
      const ColumnStatistics& s = group.columns[c];
      rows.push_back({column.measure.name, column.unit, std::to_string(s.summary.n),
                      short_number(s.summary.mean), short_interval(s.interval)});
      if (column.is_share)
        rows.back().insert(rows.back().end(), {"", "", "", "", ""});
      else
        rows.back().insert(rows.back().end(),
                           {short_number(s.summary.standard_deviation),
                            short_number(s.summary.low.value),
                            short_number(s.summary.median.value),
                            short_number(s.summary.high.value),
                            s.needed ? std::to_string(*s.needed) : "-"});
    }
    text += aligned(rows);
  }
  if (ensemble.groups.size() > most_groups)
    text += fmt::format("\nand {} more groups, which -o table.csv lists\n",
                        ensemble.groups.size() - most_groups);
  return text;
}

}  // namespace blocks::report
