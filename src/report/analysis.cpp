#include "report/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "text/number.hpp"

namespace blocks::report {
namespace {

constexpr State all_states[] = {State::done, State::unsound, State::time_limit,
                                State::failed, State::open};

/// Returns the parameters that differ between groups.
std::vector<std::size_t> varying(const Ensemble& ensemble) {
  std::vector<std::size_t> found;
  for (std::size_t p = 0; p < ensemble.parameters.size(); ++p)
    if (std::any_of(ensemble.groups.begin(), ensemble.groups.end(),
                    [&](const Group& group) {
                      return group.values[p] != ensemble.groups.front().values[p];
                    }))
      found.push_back(p);
  return found;
}

/// Returns the parameter whose values are compared: the sweep or the variant, otherwise
/// the only one that varies.
std::optional<std::size_t> compared_parameter(const Ensemble& ensemble) {
  const std::vector<std::size_t> all = varying(ensemble);
  for (const char* name : {"sweep", "variant"})
    for (const std::size_t p : all)
      if (ensemble.parameters[p] == name)
        return p;
  return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
}

std::vector<double> axis_numbers(const Ensemble& ensemble, std::size_t parameter) {
  std::vector<double> numbers;
  for (const Group& group : ensemble.groups) {
    const auto value = text::number_of<double>(group.values[parameter]);
    if (!value)
      return {};
    numbers.push_back(*value);
  }
  return numbers;
}

/// Returns the values of two groups at the seeds that both have, in their order.
void align(const Ensemble& ensemble, std::size_t first, std::size_t second,
           std::size_t column, std::vector<double>& a, std::vector<double>& b) {
  const auto in_first = ensemble.sample(first, column),
             in_second = ensemble.sample(second, column);
  const auto& rows_a = ensemble.groups[first].rows;
  const auto& rows_b = ensemble.groups[second].rows;
  a.clear(), b.clear();
  for (std::size_t i = 0, k = 0; i < rows_a.size() && k < rows_b.size();) {
    const auto &one = ensemble.rows[rows_a[i]].seed,
               &other = ensemble.rows[rows_b[k]].seed;
    if (one < other) {
      ++i;
    } else if (other < one) {
      ++k;
    } else {
      a.push_back(in_first[i++]);
      b.push_back(in_second[k++]);
    }
  }
}

std::optional<GroupDifferences>
differences_of(const Ensemble& ensemble, std::size_t group, std::size_t compared) {
  const std::string& reference_value = ensemble.groups.front().values[compared];
  std::vector<std::string> wanted = ensemble.groups[group].values;
  if (wanted[compared] == reference_value)
    return std::nullopt;
  wanted[compared] = reference_value;
  const auto found =
      std::find_if(ensemble.groups.begin(), ensemble.groups.end(),
                   [&](const Group& one) { return one.values == wanted; });
  if (found == ensemble.groups.end())
    return std::nullopt;
  GroupDifferences differences;
  differences.reference = static_cast<std::size_t>(found - ensemble.groups.begin());
  std::vector<double> a, b;
  for (std::size_t c = 0; c < ensemble.columns.size(); ++c) {
    align(ensemble, differences.reference, group, c, a, b);
    differences.columns.push_back(paired_difference(a, b));
  }
  return differences;
}

ColumnStatistics statistics_of(const Ensemble& ensemble, std::size_t group,
                               std::size_t column, const Precision& precision) {
  ColumnStatistics found;
  const std::vector<double> values = ensemble.sample(group, column);
  const auto& rows = ensemble.groups[group].rows;
  found.summary = summarize(values);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (ensemble.counts(ensemble.rows[rows[i]]) && !std::isfinite(values[i]))
      ++found.missing;
  found.interval = found.summary.mean_interval;
  if (ensemble.columns[column].is_share) {
    const auto hits = std::count(values.begin(), values.end(), 1.0);
    found.interval = wilson(static_cast<std::size_t>(hits), found.summary.n);
  } else {
    found.needed = needed_runs(found.summary, precision);
  }
  if (found.summary.n > 0) {
    found.min_row = rows[found.summary.min_at];
    found.max_row = rows[found.summary.max_at];
  }
  return found;
}

}  // namespace

const char* name_of(State state) {
  switch (state) {
  case State::done:
    return "done";
  case State::unsound:
    return "unsound";
  case State::time_limit:
    return "time limit";
  case State::failed:
    return "failed";
  case State::open:
    break;
  }
  return "not finished";
}

Analysis analyse(const Ensemble& ensemble, const Precision& precision) {
  Analysis analysis;
  analysis.precision = precision;
  analysis.compared = compared_parameter(ensemble);
  if (analysis.compared && varying(ensemble).size() == 1)
    analysis.axis = axis_numbers(ensemble, *analysis.compared);
  for (std::size_t g = 0; g < ensemble.groups.size(); ++g) {
    GroupStatistics group;
    std::map<State, std::size_t> counts;
    for (const std::size_t r : ensemble.groups[g].rows)
      ++counts[ensemble.rows[r].state];
    group.ended = ensemble.groups[g].rows.size() - counts[State::open];
    for (const State state : all_states)
      group.outcomes.push_back(
          {state, counts[state],
           state == State::open ? Interval{} : wilson(counts[state], group.ended)});
    for (std::size_t c = 0; c < ensemble.columns.size(); ++c)
      group.columns.push_back(statistics_of(ensemble, g, c, precision));
    for (const std::size_t r : ensemble.groups[g].rows)
      if (const RunRow& row = ensemble.rows[r]; ensemble.counts(row) && row.safety)
        group.failure.add(*row.safety);
    std::vector<const std::vector<double>*> profiles;
    for (const std::size_t r : ensemble.groups[g].rows)
      if (!ensemble.rows[r].profile.empty())
        profiles.push_back(&ensemble.rows[r].profile);
    if (!profiles.empty())
      group.profile = band_of(profiles);
    if (analysis.compared)
      group.differences = differences_of(ensemble, g, *analysis.compared);
    analysis.groups.push_back(std::move(group));
  }
  analysis.sensitivities = sensitivities(ensemble);
  return analysis;
}

std::optional<std::size_t> median_run(const Ensemble& ensemble,
                                      const Analysis& analysis, std::size_t group,
                                      std::size_t column) {
  const double median = analysis.groups[group].columns[column].summary.median.value;
  std::optional<std::size_t> nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (const std::size_t r : ensemble.groups[group].rows) {
    const RunRow& row = ensemble.rows[r];
    if (!ensemble.counts(row))
      continue;
    const double away = std::abs(row.values[column] - median);
    if (!nearest || away < distance) {
      nearest = r;
      distance = std::isnan(away) ? distance : away;
    }
  }
  return nearest;
}

}  // namespace blocks::report
