#include "report/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/table_cells.hpp"
#include "text/table.hpp"

namespace blocks::report {
namespace {

/// Returns the rows of the design for one measure. `runs` are the rows of the ensemble
/// in the order of the plan.
std::vector<SobolRow> rows_of(const Ensemble& ensemble, std::size_t column,
                              const std::vector<std::size_t>& runs,
                              std::size_t runs_per_row) {
  const auto value = [&](std::size_t at) {
    const RunRow& run = ensemble.rows[runs[at]];
    return run.state == State::done ? run.values[column] : no_number;
  };
  std::vector<SobolRow> rows;
  for (std::size_t at = 0; at + runs_per_row <= runs.size(); at += runs_per_row) {
    SobolRow row{value(at), value(at + 1), {}};
    for (std::size_t i = 2; i < runs_per_row; ++i)
      row.mixed.push_back(value(at + i));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

std::vector<Sensitivity> sensitivities(const Ensemble& ensemble) {
  std::vector<Sensitivity> all;
  for (std::size_t m = 0; m < ensemble.members.size(); ++m) {
    const auto& design = ensemble.members[m].plan.sobol;
    if (!design)
      continue;
    std::vector<std::size_t> runs;
    for (std::size_t r = 0; r < ensemble.rows.size(); ++r)
      if (ensemble.rows[r].member == m)
        runs.push_back(r);
    Sensitivity found{m, ensemble.rows[runs.front()].group, {}, {}};
    for (const sweep::SobolRange& range : design->ranges)
      found.parameters.push_back(range.field);
    for (std::size_t c = 0; c < ensemble.columns.size(); ++c)
      found.quantities.push_back(
          sobol_indices(rows_of(ensemble, c, runs, design->runs_per_row())));
    all.push_back(std::move(found));
  }
  return all;
}

std::string rows_words(const SobolIndices& indices) {
  const std::size_t all = indices.rows + indices.left_out;
  if (indices.left_out == 0)
    return fmt::format("{} rows", all);
  return fmt::format("{} of {} rows; {} left out, because a run has no value",
                     indices.rows, all, indices.left_out);
}

std::string sensitivity_text(const Ensemble& ensemble,
                             const std::vector<Sensitivity>& all) {
  std::string text;
  for (const Sensitivity& one : all) {
    const std::string name = ensemble.name_of(ensemble.groups[one.group]);
    for (std::size_t c = 0; c < ensemble.columns.size(); ++c) {
      const SobolIndices& indices = one.quantities[c];
      text +=
          fmt::format("\n{}{}Sobol indices of {}, {}\n", name, name.empty() ? "" : ": ",
                      ensemble.columns[c].measure.name, rows_words(indices));
      std::vector<std::vector<std::string>> rows = {
          {"  ", "first order", "95 % interval", "total", "95 % interval"}};
      for (std::size_t i = 0; i < one.parameters.size(); ++i) {
        const SobolIndex& index = indices.parameters[i];
        rows.push_back({"  " + one.parameters[i], short_number(index.first),
                        short_interval(index.first_interval), short_number(index.total),
                        short_interval(index.total_interval)});
      }
      text += text::aligned(rows, 1);
    }
  }
  return text;
}

}  // namespace blocks::report
