#include "report/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "deck/cards/card_table.hpp"
#include "draw/axes.hpp"
#include "draw/number_text.hpp"

namespace blocks::report {
namespace {

using Form = draw::ChartLine::Form;

constexpr quantities::Dimension length{1, 0, 0, "m", ""};

/// Returns the values of a group that are finite.
std::vector<double> finite_sample(const Ensemble& ensemble, std::size_t group,
                                  std::size_t column) {
  std::vector<double> values = ensemble.sample(group, column);
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  return values;
}

bool all_whole(const std::vector<double>& values) {
  constexpr double largest = 1e9;
  return std::all_of(values.begin(), values.end(), [](double value) {
    return value == std::round(value) && std::abs(value) < largest;
  });
}

draw::ChartLine mark(const std::string& legend, double at) {
  draw::ChartLine line{legend, {at}, {0.0}};
  line.form = Form::mark;
  return line;
}

/// Returns the bars of values in bins of equal width.
draw::ChartLine bars(const std::vector<double>& values,
                     const std::vector<double>& boundaries) {
  draw::ChartLine line;
  line.form = Form::bars;
  line.bar = boundaries[1] - boundaries[0];
  for (std::size_t i = 0; i + 1 < boundaries.size(); ++i) {
    line.x.push_back(0.5 * (boundaries[i] + boundaries[i + 1]));
    line.y.push_back(0.0);
  }
  for (const double value : values) {
    const auto above = std::upper_bound(boundaries.begin(), boundaries.end(), value);
    const auto bin = std::clamp<std::ptrdiff_t>(above - boundaries.begin() - 1, 0,
                                                std::ssize(line.y) - 1);
    line.y[static_cast<std::size_t>(bin)] += 1.0;
  }
  return line;
}

/// Returns the groups that a figure shows: all, or some at equal distances if there are
/// too many.
std::vector<std::size_t> drawn_groups(const std::vector<std::size_t>& with_values) {
  if (with_values.size() <= max_groups_drawn)
    return with_values;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < max_groups_drawn; ++i)
    some.push_back(with_values[i * (with_values.size() - 1) / (max_groups_drawn - 1)]);
  return some;
}

/// The points of the groups in ascending order of the parameter.
draw::ChartLine points(const Analysis& analysis) {
  draw::ChartLine line;
  line.form = Form::intervals;
  line.x = analysis.axis;
  std::sort(line.x.begin(), line.x.end());
  return line;
}

/// Returns the label of the axis of a parameter: "coefficient of friction
/// (FRICTN.fric)". It is the name alone if the table of cards has no short words for
/// the field.
std::string parameter_label(const std::string& name) {
  constexpr std::size_t longest = 42;  // letters below a figure of one column
  const auto dot = name.find('.');
  if (dot == std::string::npos)
    return name;
  const deck::CardSpec* card =
      deck::find_card(name.substr(0, name.find_first_of(".[")));
  const auto field =
      card != nullptr ? card->find_field(name.substr(dot + 1)) : std::nullopt;
  if (!field)
    return name;
  const std::string_view help = card->fields[*field].help;
  std::string label =
      fmt::format("{} ({})", help.substr(0, help.find_first_of(",;:(")), name);
  return label.size() <= longest ? label : name;
}

draw::Chart parameter_chart(const Ensemble& ensemble, const Analysis& analysis,
                            draw::ChartLine line, const std::string& y_label) {
  if (std::none_of(line.y.begin(), line.y.end(),
                   [](double y) { return std::isfinite(y); }))
    return {};
  draw::Chart chart;
  chart.x_label = parameter_label(ensemble.parameters[*analysis.compared]);
  chart.panels = {{y_label, {std::move(line)}}};
  return chart;
}

std::string file_name(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '_')
      c = '-';
  return name;
}

/// Returns the group of a sweep in the name of a file; empty if there is only one.
std::string group_suffix(const Ensemble& ensemble, const Sensitivity& one) {
  const std::string name = ensemble.name_of(ensemble.groups[one.group]);
  return name.empty() ? "" : "-" + name;
}

/// Returns the groups in ascending order of the parameter.
std::vector<std::size_t> by_parameter(const Analysis& analysis) {
  std::vector<std::size_t> order(analysis.axis.size());
  for (std::size_t g = 0; g < order.size(); ++g)
    order[g] = g;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return analysis.axis[a] < analysis.axis[b];
  });
  return order;
}

}  // namespace

std::vector<double> bin_boundaries(std::vector<double> values) {
  constexpr double fewest = 5.0, max = 40.0;
  std::sort(values.begin(), values.end());
  const double low = values.front(), high = values.back(), range = high - low;
  if (all_whole(values) && range <= max) {
    std::vector<double> around;
    for (double at = low - 0.5; at <= high + 0.5; at += 1.0)
      around.push_back(at);
    return around;
  }
  const double middle = 0.5 * (low + high);
  if (!(range > 1e-9 * std::abs(middle))) {
    const double half = low == 0.0 ? 0.5 : 0.05 * std::abs(middle);
    return {middle - half, middle + half};
  }
  const double spread = sorted_quantile(values, 0.75) - sorted_quantile(values, 0.25);
  const double width = 2.0 * spread / std::cbrt(static_cast<double>(values.size()));
  const double count = std::clamp(width > 0.0 ? range / width : fewest, fewest, max);
  const std::vector<double> ticks =
      draw::nice_ticks(low, high, static_cast<int>(std::lround(count)));
  if (ticks.size() < 2)
    return {low, high};
  const double step =
      (ticks.back() - ticks.front()) / static_cast<double>(ticks.size() - 1);
  std::vector<double> boundaries;
  if (low < ticks.front())
    boundaries.push_back(ticks.front() - step);
  boundaries.insert(boundaries.end(), ticks.begin(), ticks.end());
  if (high > ticks.back())
    boundaries.push_back(ticks.back() + step);
  return boundaries;
}

draw::Chart profile_chart(const Ensemble& ensemble, const Analysis& analysis) {
  if (!ensemble.profile)
    return {};
  const auto* kind = quantities::find_quantity(ensemble.profile->quantity);
  draw::Chart chart;
  draw::ChartPanel panel{
      draw::with_unit(kind->label, post::unit_text(kind->dimension, ensemble.units)),
      {}};
  std::vector<std::size_t> with_profile;
  for (std::size_t g = 0; g < analysis.groups.size(); ++g)
    if (analysis.groups[g].profile)
      with_profile.push_back(g);
  for (const std::size_t g : drawn_groups(with_profile)) {
    const auto& band = analysis.groups[g].profile;
    const std::string name = ensemble.name_of(ensemble.groups[g]);
    draw::ChartLine line{name.empty() ? "median" : name, ensemble.positions,
                         band->median};
    if (band->runs > 1) {
      line.low = band->low;
      line.high = band->high;
      line.band_legend = fmt::format("5 to 95 % of {} runs", band->runs);
    }
    panel.lines.push_back(std::move(line));
  }
  if (panel.lines.empty())
    return {};
  chart.x_label =
      draw::with_unit(ensemble.profile->line.segment ? "distance along the line" : "x",
                      post::unit_text(length, ensemble.units));
  chart.panels = {panel};
  return chart;
}

draw::Chart histogram(const Ensemble& ensemble, const Analysis& analysis,
                      std::size_t column) {
  const Column& what = ensemble.columns[column];
  if (what.is_share)
    return {};
  std::vector<double> all;
  std::vector<std::size_t> with_values;
  for (std::size_t g = 0; g < ensemble.groups.size(); ++g) {
    const auto values = finite_sample(ensemble, g, column);
    all.insert(all.end(), values.begin(), values.end());
    if (!values.empty())
      with_values.push_back(g);
  }
  if (all.size() < 2)
    return {};
  const std::vector<double> boundaries = bin_boundaries(all);
  draw::Chart chart;
  chart.x_label = draw::with_unit(what.label, what.unit);
  for (const std::size_t g : drawn_groups(with_values)) {
    const auto values = finite_sample(ensemble, g, column);
    const Summary& summary = analysis.groups[g].columns[column].summary;
    draw::ChartPanel panel{"runs", {bars(values, boundaries)}};
    panel.lines.front().legend = ensemble.name_of(ensemble.groups[g]);
    panel.lines.push_back(
        mark(fmt::format("median {:.4g}", summary.median.value), summary.median.value));
    chart.panels.push_back(std::move(panel));
  }
  return chart;
}

draw::Chart against_parameter(const Ensemble& ensemble, const Analysis& analysis,
                              std::size_t column) {
  if (analysis.axis.empty())
    return {};
  const Column& what = ensemble.columns[column];
  draw::ChartLine line = points(analysis);
  for (const std::size_t g : by_parameter(analysis)) {
    const ColumnStatistics& found = analysis.groups[g].columns[column];
    line.y.push_back(found.summary.mean);
    line.low.push_back(found.interval.low);
    line.high.push_back(found.interval.high);
  }
  line.legend = what.label;
  // A mean of one run has no interval.
  if (std::any_of(line.low.begin(), line.low.end(),
                  [](double low) { return std::isfinite(low); }))
    line.band_legend =
        what.is_share ? "95 % interval (Wilson)" : "95 % interval of the mean";
  return parameter_chart(ensemble, analysis, std::move(line),
                         what.is_share ? "share of runs"
                                       : draw::with_unit("mean", what.unit));
}

draw::Chart differences(const Ensemble& ensemble, const Analysis& analysis,
                        std::size_t column) {
  const Column& what = ensemble.columns[column];
  if (analysis.axis.empty() || what.is_share)
    return {};
  draw::ChartLine line = points(analysis);
  std::string reference;
  for (const std::size_t g : by_parameter(analysis)) {
    const auto& from = analysis.groups[g].differences;
    Summary summary;
    summary.mean = 0.0;  // of the reference from itself
    if (from)
      summary = from->columns[column];
    if (from)
      reference = ensemble.name_of(ensemble.groups[from->reference]);
    line.y.push_back(summary.mean);
    line.low.push_back(summary.mean_interval.low);
    line.high.push_back(summary.mean_interval.high);
  }
  line.legend = fmt::format("{}: from {}", what.label, reference);
  line.band_legend = "95 % interval of the mean difference";
  return parameter_chart(ensemble, analysis, std::move(line),
                         draw::with_unit("difference", what.unit));
}

std::vector<NamedChart> all_charts(const Ensemble& ensemble, const Analysis& analysis) {
  std::vector<NamedChart> charts;
  const auto add = [&](const std::string& name, draw::Chart chart) {
    if (!chart.panels.empty())
      charts.push_back({file_name(name), std::move(chart)});
  };
  add("profile", profile_chart(ensemble, analysis));
  for (std::size_t c = 0; c < ensemble.columns.size(); ++c) {
    const std::string name = ensemble.columns[c].measure.name;
    add("histogram-" + name, histogram(ensemble, analysis, c));
    add("mean-" + name, against_parameter(ensemble, analysis, c));
    add("difference-" + name, differences(ensemble, analysis, c));
    for (const Sensitivity& one : analysis.sensitivities)
      if (draw::DotChart chart = index_chart(ensemble, one, c); !chart.names.empty())
        charts.push_back({file_name("sobol-" + name + group_suffix(ensemble, one)),
                          std::move(chart)});
  }
  return charts;
}

}  // namespace blocks::report
