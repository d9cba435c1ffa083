#include "report/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace blocks::report {

std::size_t Ensemble::main_column() const {
  const auto found =
      std::find_if(columns.begin(), columns.end(),
                   [](const Column& column) { return !column.is_share; });
  return found == columns.end() ? 0 : static_cast<std::size_t>(found - columns.begin());
}

std::vector<double> Ensemble::sample(std::size_t group, std::size_t column) const {
  std::vector<double> values;
  values.reserve(groups[group].rows.size());
  for (const std::size_t r : groups[group].rows)
    values.push_back(counts(rows[r]) ? rows[r].values[column] : no_number);
  return values;
}

std::vector<std::string> Ensemble::sampled_values(const RunRow& row) const {
  std::vector<std::string> values(sampled.size());
  const sweep::Plan& plan = members[row.member].plan;
  if (!plan.sobol)
    return values;
  for (const std::string& set : plan.runs[row.id - 1].sets)
    for (std::size_t i = 0; i < sampled.size(); ++i)
      if (sampled[i] == sweep::field_of(set) && plan.sobol->has(sampled[i]))
        values[i] = sweep::value_of(set);
  return values;
}

std::string Ensemble::folder_of(const RunRow& row) const {
  return sweep::run_folder(members[row.member].folder, row.id);
}

std::string Ensemble::results_of(const RunRow& row) const {
  return results_path(members[row.member], row.id);
}

std::string Ensemble::name_of(const Group& group) const {
  std::string name;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    name += fmt::format("{}{} = {}", name.empty() ? "" : ", ", parameters[p],
                        group.values[p].empty() ? "as in the deck" : group.values[p]);
  return name;
}

}  // namespace blocks::report
