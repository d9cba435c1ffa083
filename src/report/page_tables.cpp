// The tables of the page.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/html_text.hpp"
#include "report/name_list.hpp"
#include "report/page_writer.hpp"

namespace blocks::report {
namespace {

/// The most rows of the table of runs, and the most groups with a table of their own.
constexpr std::size_t max_rows = 1000, max_group_rows = 400;

/// Returns the name of a measure as two lines: in words, and as the user writes it.
std::string column_name(const Column& column) {
  const std::string label = escaped(capital(column.label));
  return column.label == column.measure.name
             ? label
             : label + "<small><code>" + escaped(column.measure.name) +
                   "</code></small>";
}

std::string deck_words(const std::string& parameter_value) {
  return parameter_value.empty() ? "as in the deck" : parameter_value;
}

bool has_failed(const RunRow& row) {
  return row.state != State::done && row.state != State::open;
}

/// Returns an index with three decimals, and its interval.
std::string index_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.3f}", value) : "–";
}
std::string index_interval(double value, const Interval& interval) {
  return std::isfinite(value)
             ? fmt::format("{:.3f} to {:.3f}", interval.low, interval.high)
             : "–";
}

}  // namespace

void PageWriter::parameter_heads(HtmlTable& table, const std::string& marks) const {
  for (const std::string& parameter : all_.parameters)
    table.head(escaped(parameter), marks + HtmlTable::left);
}

void PageWriter::parameter_cells(HtmlTable& table, const Group& group) const {
  for (const std::string& value : group.values)
    table.cell(escaped(deck_words(value)), HtmlTable::left);
}

std::size_t PageWriter::shown_groups() const {
  return std::min(all_.groups.size(), max_group_rows);
}

void PageWriter::group_table(
    const std::vector<std::string>& heads,
    const std::function<void(HtmlTable&, std::size_t)>& cells) {
  HtmlTable table;
  parameter_heads(table);
  table.heads(heads);
  for (std::size_t g = 0; g < shown_groups(); ++g) {
    table.row();
    parameter_cells(table, all_.groups[g]);
    cells(table, g);
  }
  text_ += table.html();
  if (all_.groups.size() > max_group_rows)
    text_ += fmt::format("<p class=\"note\">The first {} of {} groups; "
                         "<code>-o table.csv</code> has all.</p>\n",
                         max_group_rows, all_.groups.size());
}

void PageWriter::outcome_table() {
  std::vector<std::string> heads;
  for (const OutcomeCount& one : analysis_.groups.front().outcomes)
    heads.emplace_back(name_of(one.state));
  heads.insert(heads.end(), {"share done", "95 % interval"});
  group_table(heads, [&](HtmlTable& table, std::size_t g) {
    const GroupStatistics& group = analysis_.groups[g];
    for (const OutcomeCount& one : group.outcomes)
      table.cell(std::to_string(one.count));
    const OutcomeCount& done = group.outcomes.front();
    table.cell(percent_text(static_cast<double>(done.count) /
                            static_cast<double>(group.ended)));
    table.cell(percents_text(done.share), HtmlTable::range);
  });
}

void PageWriter::failures() {
  const auto& groups = analysis_.groups;
  if (std::none_of(groups.begin(), groups.end(), [](const GroupStatistics& group) {
        return group.failure.total() > 0;
      }))
    return;
  text_ += "<section>\n<h2>Factor of safety</h2>\n<p>" +
           (several_ ? "" : escaped(failure_words(groups.front().failure)) + ". ") +
           "A run has F &lt; 1 if the upper proved end is at most 1, and not if the "
           "lower one is at least 1. Otherwise it is undecided and counts as "
           "neither.</p>\n";
  if (several_)
    group_table({"F &lt; 1", "F ≥ 1", "undecided", "share F &lt; 1", "95 % interval"},
                [&](HtmlTable& table, std::size_t g) {
                  const FailureCount& count = groups[g].failure;
                  table.cells(
                      {std::to_string(count.failing), std::to_string(count.stable),
                       std::to_string(count.undecided), percent_text(count.share())});
                  table.cell(percents_text(count.interval()), HtmlTable::range);
                });
  text_ += "</section>\n";
}

void PageWriter::statistics_cells(HtmlTable& table, const Column& column,
                                  const ColumnStatistics& found) const {
  const Summary& s = found.summary;
  if (column.is_share) {
    table.cells({std::to_string(s.n), percent_text(s.mean)});
    table.cell(percents_text(found.interval),
               std::string(HtmlTable::range) + (several_ ? "" : " colspan=\"7\""));
    return;
  }
  const auto extreme = [&](double value, std::size_t row) {
    return s.n == 0 ? std::string("–")
                    : number_text(value) + "<small>" + seed_link(row) + "</small>";
  };
  table.cells({std::to_string(s.n), mean_text(s.mean, found.interval),
               number_text(s.standard_deviation), number_text(s.low.value),
               number_text(s.median.value) + "<small>" +
                   interval_text(s.median.interval) + "</small>",
               number_text(s.high.value), extreme(s.min, found.min_row),
               extreme(s.max, found.max_row),
               found.needed ? std::to_string(*found.needed) : "–"});
}

void PageWriter::statistics() {
  const std::vector<std::string> heads = {"n",
                                          "mean ± 95 %",
                                          "sd",
                                          "5 %",
                                          "median<br><small>95 % interval</small>",
                                          "95 %",
                                          "min",
                                          "max",
                                          "runs for<br>± " +
                                              analysis_.precision.words()};
  text_ += "<section id=\"statistics\">\n<h2>Statistics</h2>\n";
  if (several_) {
    for (std::size_t c = 0; c < all_.columns.size(); ++c) {
      const Column& column = all_.columns[c];
      if (column.is_share && shares_shown_)
        continue;
      text_ += "<h3>" + column_caption(c) +
               (column.unit.empty() ? "" : " [" + escaped(column.unit) + "]") +
               "</h3>\n";
      group_table(column.is_share
                      ? std::vector<std::string>{"n", "share", "95 % interval"}
                      : heads,
                  [&](HtmlTable& table, std::size_t g) {
                    statistics_cells(table, column, analysis_.groups[g].columns[c]);
                  });
    }
  } else {
    HtmlTable table;
    table.head("quantity", HtmlTable::left);
    table.head("unit", HtmlTable::left);
    table.heads(heads);
    for (std::size_t c = 0; c < all_.columns.size() && !analysis_.groups.empty(); ++c) {
      table.row();
      table.row_head(column_name(all_.columns[c]));
      table.cell(escaped(all_.columns[c].unit), HtmlTable::left);
      statistics_cells(table, all_.columns[c], analysis_.groups.front().columns[c]);
    }
    text_ += table.html();
  }
  text_ += "</section>\n";
}

void PageWriter::differences() {
  if (std::none_of(analysis_.groups.begin(), analysis_.groups.end(),
                   [](const GroupStatistics& g) { return g.differences.has_value(); }))
    return;
  HtmlTable table;
  table.head("quantity", HtmlTable::left);
  parameter_heads(table);
  table.head("reference", HtmlTable::left);
  table.heads({"pairs", "mean ± 95 %", "sd", "5 %", "median", "95 %"});
  for (std::size_t c = 0; c < all_.columns.size(); ++c)
    for (std::size_t g = 0; g < shown_groups(); ++g) {
      const auto& found = analysis_.groups[g].differences;
      if (!found || all_.columns[c].is_share)
        continue;
      const Summary& s = found->columns[c];
      const Group& reference = all_.groups[found->reference];
      table.row();
      table.row_head(column_name(all_.columns[c]));
      parameter_cells(table, all_.groups[g]);
      table.cell(escaped(deck_words(reference.values[*analysis_.compared])),
                 HtmlTable::left);
      table.cells({std::to_string(s.n),
                   number_with_unit(mean_text(s.mean, s.mean_interval),
                                    escaped(all_.columns[c].unit)),
                   number_text(s.standard_deviation), number_text(s.low.value),
                   number_text(s.median.value), number_text(s.high.value)});
    }
  text_ += "<section>\n<h2>Paired differences</h2>\n<p>Value minus that of the "
           "reference with the same seed. If the 95 % interval of the mean does not "
           "contain 0, the difference is significant at the level of 5 %.</p>\n" +
           table.html() + "</section>\n";
}

void PageWriter::variant_tables() {
  const auto scene = parameter_index("scene"), variant = parameter_index("variant");
  if (!scene || !variant || all_.parameters.size() != 2)
    return;
  shares_shown_ = true;
  std::vector<std::string> scenes, variants;
  for (const Group& group : all_.groups) {
    add_once(scenes, group.values[*scene]);
    add_once(variants, group.values[*variant]);
  }
  for (std::size_t c = 0; c < all_.columns.size(); ++c) {
    if (!all_.columns[c].is_share)
      continue;
    HtmlTable table;
    table.head("scene", HtmlTable::left);
    for (const std::string& name : variants)
      table.head(escaped(name));
    for (const std::string& of_scene : scenes) {
      table.row();
      table.cell(escaped(of_scene), HtmlTable::left);
      for (const std::string& of_variant : variants)
        table.cell(share_text(c, [&](const Group& group) {
          return group.values[*scene] == of_scene &&
                 group.values[*variant] == of_variant;
        }));
    }
    text_ += "<section>\n<h2>" + column_caption(c) +
             "</h2>\n<p>Share of the frames, and below it the 95 % interval.</p>\n" +
             table.html() + "</section>\n";
  }
}

std::string
PageWriter::share_text(std::size_t column,
                       const std::function<bool(const Group&)>& is_meant) const {
  for (std::size_t g = 0; g < all_.groups.size(); ++g) {
    const ColumnStatistics& found = analysis_.groups[g].columns[column];
    if (found.summary.n > 0 && is_meant(all_.groups[g]))
      return percent_text(found.summary.mean) + "<small>" +
             percents_text(found.interval) + "</small>";
  }
  return "–";
}

void PageWriter::index_table(const Sensitivity& one, std::size_t column) {
  const SobolIndices& indices = one.quantities[column];
  HtmlTable table;
  table.head("parameter", HtmlTable::left);
  table.heads({"first order", "95 % interval", "total", "95 % interval"});
  for (std::size_t i = 0; i < one.parameters.size(); ++i) {
    const SobolIndex& index = indices.parameters[i];
    table.row();
    table.row_head(escaped(one.parameters[i]));
    table.cell(index_text(index.first));
    table.cell(index_interval(index.first, index.first_interval), HtmlTable::range);
    table.cell(index_text(index.total));
    table.cell(index_interval(index.total, index.total_interval), HtmlTable::range);
  }
  text_ += fmt::format("<h3>{}</h3>\n<p class=\"note\">{}</p>\n",
                       column_caption(column), rows_words(indices)) +
           table.html();
}

std::vector<std::size_t> PageWriter::shown_rows() const {
  std::set<std::size_t> shown;
  const bool all = all_.rows.size() <= max_rows;
  if (!all) {
    shown.insert(typical_.begin(), typical_.end());
    for (const GroupStatistics& group : analysis_.groups)
      for (const ColumnStatistics& one : group.columns)
        if (one.summary.n > 0 && shown.size() + 2 <= max_rows / 2)
          shown.insert({one.min_row, one.max_row});
    for (std::size_t r = 0; r < all_.rows.size() && shown.size() < max_rows * 3 / 4;
         ++r)
      if (has_failed(all_.rows[r]))
        shown.insert(r);
  }
  for (std::size_t r = 0; r < all_.rows.size() && (all || shown.size() < max_rows); ++r)
    shown.insert(r);
  return {shown.begin(), shown.end()};
}

void PageWriter::run_table() {
  const std::vector<std::size_t> shown = shown_rows();
  HtmlTable table;
  const std::string sorted = "data-sort";
  table.head("run", sorted);
  parameter_heads(table, sorted + ' ');
  for (const std::string& field : all_.sampled)
    table.head(escaped(field), sorted);
  table.head(seed_word(), sorted);
  table.head("outcome", sorted + ' ' + HtmlTable::left);
  for (const Column& column : all_.columns)
    table.head("<code>" + escaped(column.measure.name) + "</code>" +
                   (column.unit.empty() ? "" : "<br>" + escaped(column.unit)),
               sorted);
  for (const std::size_t r : shown)
    run_row(table, r);
  text_ += fmt::format(
      "<section id=\"runs\">\n<h2>Runs</h2>\n<p>Each run is a link to its {}. A click "
      "on a heading sorts the table.",
      all_.kind() == sweep::Kind::run ? "own page" : "log");
  if (shown.size() < all_.rows.size())
    text_ += fmt::format(" The table has {} of {} runs: those that failed, the typical "
                         "and the extreme ones, and the first ones. "
                         "<code>--run-table runs.csv</code> writes all of them.",
                         shown.size(), all_.rows.size());
  text_ += "</p>\n" + table.html() + "</section>\n";
}

void PageWriter::run_row(HtmlTable& table, std::size_t r) const {
  const RunRow& row = all_.rows[r];
  const bool bad = has_failed(row);
  table.row(bad ? "class=\"bad\"" : "");
  table.cell(run_link(r, std::to_string(row.id)));
  parameter_cells(table, all_.groups[row.group]);
  for (const std::string& value : all_.sampled_values(row))
    table.cell(escaped(value));
  table.cell(row.seed ? std::to_string(*row.seed) : "–");
  table.cell(fmt::format("<span class=\"state\"><i class=\"{}\"></i>{}{}</span>{}",
                         class_of(row.state), escaped(row.status),
                         bad && row.code ? fmt::format(" (exit {})", *row.code) : "",
                         row.message.empty() ? ""
                                             : "<small class=\"message\">" +
                                                   escaped(row.message) + "</small>"),
             HtmlTable::left);
  for (const double value : row.values)
    table.cell(number_text(value),
               fmt::format("data-v=\"{}\"",
                           std::isfinite(value) ? fmt::format("{}", value) : ""));
}

}  // namespace blocks::report
