// The tables for the terminal.
#include <fmt/format.h>

#include <algorithm>

#include "report/table_cells.hpp"
#include "report/tables.hpp"
#include "text/table.hpp"

namespace blocks::report {

std::string statistics_text(const Ensemble& ensemble, const Analysis& analysis) {
  std::string text = ensemble.title.empty() ? "" : ensemble.title + '\n';
  text += sweep_words(ensemble) + '\n';
  constexpr std::size_t max_groups = 20;
  for (std::size_t g = 0; g < std::min(ensemble.groups.size(), max_groups); ++g) {
    const GroupStatistics& group = analysis.groups[g];
    const std::string name = ensemble.name_of(ensemble.groups[g]);
    text +=
        fmt::format("\n{}{}{}\n", name, name.empty() ? "" : ": ", outcome_words(group));
    if (group.failure.total() > 0)
      text += failure_words(group.failure) + '\n';
    std::vector<std::vector<std::string>> rows = {
        {"  ", "unit", "n", "mean", "95 % interval", "sd", "5 %", "median", "95 %",
         "runs for " + analysis.precision.words()}};
    for (std::size_t c = 0; c < ensemble.columns.size(); ++c) {
      const Column& column = ensemble.columns[c];
      const ColumnStatistics& s = group.columns[c];
      rows.push_back({"  " + column.measure.name, column.unit,
                      std::to_string(s.summary.n), short_number(s.summary.mean),
                      short_interval(s.interval)});
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
    text += text::aligned(rows, 1);
  }
  if (ensemble.groups.size() > max_groups)
    text += fmt::format("\nand {} more groups, which -o table.csv lists\n",
                        ensemble.groups.size() - max_groups);
  return text + sensitivity_text(ensemble, analysis.sensitivities);
}

}  // namespace blocks::report
