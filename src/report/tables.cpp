#include "report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/table_cells.hpp"
#include "text/table.hpp"

namespace blocks::report {
namespace {

using text::csv_cell;

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
  std::string line = fmt::format(
      "quantity,{},{},{},{},{},{},{},{},{},{}", csv_cell(column.measure.name),
      csv_cell(column.unit), s.n, found.missing,
      column.is_share && s.n > 0 ? std::to_string(std::lround(hits)) : "", cell(s.mean),
      cell(found.interval.low), cell(found.interval.high),
      column.is_share ? "wilson" : "t", cell(s.standard_deviation));
  if (column.is_share) {
    line += std::string(15, ',');
  } else {
    add_quantiles(line, s);
    line += fmt::format(",{},{},{},{},{},", cell(s.min),
                        s.n > 0 ? seed_cell(ensemble, found.min_row) : "", cell(s.max),
                        s.n > 0 ? seed_cell(ensemble, found.max_row) : "",
                        found.needed ? std::to_string(*found.needed) : "");
  }
  return line + '\n';
}

std::string difference_row(const Ensemble& ensemble, const Column& column,
                           const Summary& s, std::size_t reference) {
  std::string line =
      fmt::format("difference,{},{},{},,,{},{},{},t,{}", csv_cell(column.measure.name),
                  csv_cell(column.unit), s.n, cell(s.mean), cell(s.mean_interval.low),
                  cell(s.mean_interval.high), cell(s.standard_deviation));
  add_quantiles(line, s);
  return line + fmt::format(",{},,{},,,{}\n", cell(s.min), cell(s.max),
                            csv_cell(ensemble.name_of(ensemble.groups[reference])));
}

/// A row for one index of a parameter, which is in the column `reference`.
std::string index_row(const char* kind, const Column& column,
                      const SobolIndices& indices, double value,
                      const Interval& interval, const std::string& parameter) {
  return fmt::format("{},{},,{},{},,{},{},{},bootstrap", kind,
                     csv_cell(column.measure.name), indices.rows, indices.left_out,
                     cell(value), cell(interval.low), cell(interval.high)) +
         std::string(16, ',') + csv_cell(parameter) + '\n';
}

/// Returns the rows of a sweep; each begins with the cells of its group.
std::string index_rows(const Ensemble& ensemble, const Sensitivity& all,
                       const std::string& begin) {
  std::string text;
  for (std::size_t c = 0; c < ensemble.columns.size(); ++c)
    for (std::size_t i = 0; i < all.parameters.size(); ++i) {
      const SobolIndices& indices = all.quantities[c];
      const SobolIndex& one = indices.parameters[i];
      text += begin + index_row("first_order", ensemble.columns[c], indices, one.first,
                                one.first_interval, all.parameters[i]);
      text += begin + index_row("total", ensemble.columns[c], indices, one.total,
                                one.total_interval, all.parameters[i]);
    }
  return text;
}

std::string parameter_cells(const Group& group) {
  std::string cells;
  for (const std::string& value : group.values)
    cells += csv_cell(value) + ',';
  return cells;
}

}  // namespace

std::string statistics_csv(const Ensemble& ensemble, const Analysis& analysis) {
  std::string text;
  for (const std::string& parameter : ensemble.parameters)
    text += csv_cell(parameter) + ',';
  text += statistics_head;
  for (std::size_t g = 0; g < ensemble.groups.size(); ++g) {
    const std::string begin = parameter_cells(ensemble.groups[g]);
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
  for (const Sensitivity& one : analysis.sensitivities)
    text += index_rows(ensemble, one, parameter_cells(ensemble.groups[one.group]));
  return text;
}

std::string runs_csv(const Ensemble& ensemble) {
  const bool several = ensemble.members.size() > 1 &&
                       std::find(ensemble.parameters.begin(), ensemble.parameters.end(),
                                 "sweep") == ensemble.parameters.end();
  std::string text = several ? "sweep,run," : "run,";
  for (const std::string& parameter : ensemble.parameters)
    text += csv_cell(parameter) + ',';
  for (const std::string& field : ensemble.sampled)
    text += csv_cell(field) + ',';
  text += "seed,outcome,code,status,message";
  for (const Column& column : ensemble.columns)
    text += ',' + csv_cell(column.measure.name);
  text += '\n';
  for (const RunRow& row : ensemble.rows) {
    if (several)
      text += csv_cell(ensemble.members[row.member].label) + ',';
    text += std::to_string(row.id) + ',';
    text += parameter_cells(ensemble.groups[row.group]);
    for (const std::string& value : ensemble.sampled_values(row))
      text += csv_cell(value) + ',';
    text +=
        fmt::format("{},{},{},{},{}", row.seed ? std::to_string(*row.seed) : "",
                    name_of(row.state), row.code ? std::to_string(*row.code) : "",
                    csv_cell(row.status), csv_cell(portable_message(ensemble, row)));
    for (const double value : row.values)
      text += ',' + cell(value);
    text += '\n';
  }
  return text;
}

}  // namespace blocks::report
