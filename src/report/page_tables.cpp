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
constexpr std::size_t most_rows = 1000, most_group_rows = 400;

/// Returns the name of a measure as two lines: in words, and as the user writes it.
std::string column_name(const Column& column) {
  const std::string code = escaped(column.measure.name);
  if (column.label == column.measure.name)
    return escaped(capital(column.label));
  return escaped(capital(column.label)) + "<small><code>" + code + "</code></small>";
}

std::string deck_words(const std::string& parameter_value) {
  return parameter_value.empty() ? "as in the deck" : parameter_value;
}

std::string precision_head(const Precision& precision) {
  return "runs for<br>± " + precision.words();
}

}  // namespace

void PageWriter::outcome_table() {
  text_ += "<div class=\"wide\"><table><thead><tr>";
  parameter_heads();
  for (const OutcomeCount& one : analysis_.groups.front().outcomes)
    text_ += fmt::format("<th>{}</th>", name_of(one.state));
  text_ += "<th>share done</th><th>95 % interval</th></tr></thead><tbody>\n";
  for (std::size_t g = 0; g < shown_groups(); ++g) {
    const GroupStatistics& group = analysis_.groups[g];
    text_ += "<tr>";
    parameter_cells(all_.groups[g]);
    for (const OutcomeCount& one : group.outcomes)
      text_ += fmt::format("<td>{}</td>", one.count);
    const OutcomeCount& done = group.outcomes.front();
    text_ +=
        fmt::format("<td>{}</td><td class=\"range\">{} to {}</td></tr>\n",
                    group.ended == 0 ? "–"
                                     : percent_text(static_cast<double>(done.count) /
                                                    static_cast<double>(group.ended)),
                    percent_text(done.share.low), percent_text(done.share.high));
  }
  text_ += "</tbody></table></div>\n";
  note_on_groups();
}

std::size_t PageWriter::shown_groups() const {
  return std::min(all_.groups.size(), most_group_rows);
}

void PageWriter::note_on_groups() {
  if (all_.groups.size() > most_group_rows)
    text_ += fmt::format("<p class=\"note\">The first {} of {} groups; "
                         "<code>-o table.csv</code> has all.</p>\n",
                         most_group_rows, all_.groups.size());
}

void PageWriter::parameter_heads() {
  for (const std::string& parameter : all_.parameters)
    text_ += "<th class=\"text\">" + escaped(parameter) + "</th>";
}

void PageWriter::parameter_cells(const Group& group) {
  for (const std::string& value : group.values)
    text_ += "<td class=\"text\">" + escaped(deck_words(value)) + "</td>";
}

void PageWriter::statistics_cells(const Column& column, const ColumnStatistics& found) {
  const Summary& s = found.summary;
  if (column.is_share) {
    text_ += fmt::format("<td>{}</td><td>{}</td><td class=\"range\"{}>{} to {}</td>",
                         s.n, percent_text(s.mean), several_ ? "" : " colspan=\"7\"",
                         percent_text(found.interval.low),
                         percent_text(found.interval.high));
    return;
  }
  const auto extreme = [&](double value, std::size_t row) {
    return s.n == 0 ? std::string("–")
                    : number_text(value) + "<small>" + seed_link(row) + "</small>";
  };
  text_ += fmt::format(
      "<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}<small>{}</small></td>"
      "<td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
      s.n, mean_text(s.mean, found.interval), number_text(s.standard_deviation),
      number_text(s.low.value), number_text(s.median.value),
      interval_text(s.median.interval), number_text(s.high.value),
      extreme(s.least, found.least_row), extreme(s.most, found.most_row),
      found.needed ? std::to_string(*found.needed) : "–");
}

void PageWriter::statistics_heads() {
  text_ += "<th>n</th><th>mean ± 95 %</th><th>sd</th><th>5 %</th><th>median"
           "<br><small>95 % interval</small></th><th>95 %</th><th>min</th><th>max</th>"
           "<th>" +
           precision_head(analysis_.precision) + "</th></tr></thead><tbody>\n";
}

void PageWriter::statistics() {
  text_ += "<section id=\"statistics\">\n<h2>Statistics</h2>\n";
  if (!several_) {
    text_ += "<div class=\"wide\"><table><thead><tr><th class=\"text\">quantity</th>"
             "<th class=\"text\">unit</th>";
    statistics_heads();
    for (std::size_t c = 0; c < all_.columns.size() && !analysis_.groups.empty(); ++c) {
      text_ += "<tr><th scope=\"row\">" + column_name(all_.columns[c]) +
               "</th><td class=\"text\">" + escaped(all_.columns[c].unit) + "</td>";
      statistics_cells(all_.columns[c], analysis_.groups.front().columns[c]);
      text_ += "</tr>\n";
    }
    text_ += "</tbody></table></div>\n</section>\n";
    return;
  }
  for (std::size_t c = 0; c < all_.columns.size(); ++c) {
    const Column& column = all_.columns[c];
    if (column.is_share && shares_shown_)
      continue;
    text_ += "<h3>" + escaped(capital(column.label)) +
             (column.unit.empty() ? "" : " [" + escaped(column.unit) + "]") +
             "</h3>\n<div class=\"wide\"><table><thead><tr>";
    parameter_heads();
    if (column.is_share)
      text_ += "<th>n</th><th>share</th><th>95 % interval</th></tr></thead><tbody>\n";
    else
      statistics_heads();
    for (std::size_t g = 0; g < shown_groups(); ++g) {
      text_ += "<tr>";
      parameter_cells(all_.groups[g]);
      statistics_cells(column, analysis_.groups[g].columns[c]);
      text_ += "</tr>\n";
    }
    text_ += "</tbody></table></div>\n";
    note_on_groups();
  }
  text_ += "</section>\n";
}

void PageWriter::differences() {
  if (std::none_of(analysis_.groups.begin(), analysis_.groups.end(),
                   [](const GroupStatistics& g) { return g.differences.has_value(); }))
    return;
  text_ += "<section>\n<h2>Paired differences</h2>\n<p>Value minus that of the "
           "reference with the same seed. If the 95 % interval of the mean does not "
           "contain 0, the difference is significant at the level of 5 %.</p>\n"
           "<div class=\"wide\"><table><thead><tr><th class=\"text\">quantity</th>";
  parameter_heads();
  text_ += "<th class=\"text\">reference</th><th>pairs</th><th>mean ± 95 %</th>"
           "<th>sd</th><th>5 %</th><th>median</th><th>95 %</th></tr></thead><tbody>\n";
  for (std::size_t c = 0; c < all_.columns.size(); ++c)
    for (std::size_t g = 0; g < shown_groups(); ++g) {
      const auto& found = analysis_.groups[g].differences;
      if (!found || all_.columns[c].is_share)
        continue;
      const Summary& s = found->columns[c];
      const std::size_t compared = *analysis_.compared;
      text_ += "<tr><th scope=\"row\">" + column_name(all_.columns[c]) + "</th>";
      parameter_cells(all_.groups[g]);
      text_ += fmt::format(
          "<td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
          "<td>{}</td><td>{}</td></tr>\n",
          escaped(deck_words(all_.groups[found->reference].values[compared])), s.n,
          number_with_unit(mean_text(s.mean, s.mean_interval),
                           escaped(all_.columns[c].unit)),
          number_text(s.standard_deviation), number_text(s.low.value),
          number_text(s.median.value), number_text(s.high.value));
    }
  text_ += "</tbody></table></div>\n</section>\n";
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
    text_ += "<section>\n<h2>" + column_caption(c) +
             "</h2>\n<p>Share of the frames, and below it the 95 % interval.</p>\n"
             "<div class=\"wide\"><table><thead><tr><th class=\"text\">scene</th>";
    for (const std::string& name : variants)
      text_ += "<th>" + escaped(name) + "</th>";
    text_ += "</tr></thead><tbody>\n";
    for (const std::string& of_scene : scenes) {
      text_ += "<tr><td class=\"text\">" + escaped(of_scene) + "</td>";
      for (const std::string& of_variant : variants)
        text_ += share_cell(c, of_scene, *scene, of_variant, *variant);
      text_ += "</tr>\n";
    }
    text_ += "</tbody></table></div>\n</section>\n";
  }
}

std::string PageWriter::share_cell(std::size_t column, const std::string& scene,
                                   std::size_t scene_at, const std::string& variant,
                                   std::size_t variant_at) const {
  for (std::size_t g = 0; g < all_.groups.size(); ++g) {
    const Group& group = all_.groups[g];
    const ColumnStatistics& found = analysis_.groups[g].columns[column];
    if (group.values[scene_at] == scene && group.values[variant_at] == variant &&
        found.summary.n > 0)
      return fmt::format(
          "<td>{}<small>{} to {}</small></td>", percent_text(found.summary.mean),
          percent_text(found.interval.low), percent_text(found.interval.high));
  }
  return "<td>–</td>";
}

std::vector<std::size_t> PageWriter::shown_rows() const {
  std::set<std::size_t> shown;
  if (all_.rows.size() <= most_rows) {
    for (std::size_t r = 0; r < all_.rows.size(); ++r)
      shown.insert(shown.end(), r);
  } else {
    shown.insert(typical_.begin(), typical_.end());
    for (const GroupStatistics& group : analysis_.groups)
      for (const ColumnStatistics& one : group.columns)
        if (one.summary.n > 0 && shown.size() + 2 <= most_rows / 2)
          shown.insert({one.least_row, one.most_row});
    for (std::size_t r = 0; r < all_.rows.size() && shown.size() < most_rows * 3 / 4;
         ++r)
      if (all_.rows[r].state != State::done && all_.rows[r].state != State::open)
        shown.insert(r);
    for (std::size_t r = 0; r < all_.rows.size() && shown.size() < most_rows; ++r)
      shown.insert(r);
  }
  return {shown.begin(), shown.end()};
}

void PageWriter::run_table() {
  const std::vector<std::size_t> shown = shown_rows();
  text_ += "<section id=\"runs\">\n<h2>Runs</h2>\n<p>" + link_words() +
           (shown.size() < all_.rows.size()
                ? fmt::format(" The table has {} of {} runs: those that failed, the "
                              "typical and the extreme ones, and the first ones. "
                              "<code>--run-table runs.csv</code> writes all of them.",
                              shown.size(), all_.rows.size())
                : "") +
           "</p>\n<div class=\"wide\"><table><thead><tr><th data-sort>run</th>";
  for (const std::string& parameter : all_.parameters)
    text_ += "<th data-sort class=\"text\">" + escaped(parameter) + "</th>";
  for (const std::string& field : all_.sampled)
    text_ += "<th data-sort>" + escaped(field) + "</th>";
  text_ += fmt::format("<th data-sort>{}</th>", seed_word()) +
           "<th data-sort class=\"text\">outcome</th>";
  for (const Column& column : all_.columns)
    text_ += "<th data-sort><code>" + escaped(column.measure.name) + "</code>" +
             (column.unit.empty() ? "" : "<br>" + escaped(column.unit)) + "</th>";
  text_ += "</tr></thead><tbody>\n";
  for (const std::size_t r : shown)
    run_row(r);
  text_ += "</tbody></table></div>\n</section>\n";
}

std::string PageWriter::link_words() const {
  return all_.kind() == sweep::Kind::run
             ? "Each run is a link to its own page. A click on a heading sorts the "
               "table."
             : "Each run is a link to its log. A click on a heading sorts the table.";
}

void PageWriter::run_row(std::size_t r) {
  const RunRow& row = all_.rows[r];
  const bool bad = row.state != State::done && row.state != State::open;
  text_ += fmt::format("<tr{}><td>{}</td>", bad ? " class=\"bad\"" : "",
                       run_link(r, std::to_string(row.id)));
  for (const std::string& value : all_.groups[row.group].values)
    text_ += "<td class=\"text\">" + escaped(deck_words(value)) + "</td>";
  for (const std::string& value : all_.sampled_values(row))
    text_ += "<td>" + escaped(value) + "</td>";
  text_ += fmt::format(
      "<td>{}</td><td class=\"text\"><span class=\"state\"><i class=\"{}\"></i>{}{}"
      "</span>{}</td>",
      row.seed ? std::to_string(*row.seed) : "–", class_of(row.state),
      escaped(row.status), bad && row.code ? fmt::format(" (exit {})", *row.code) : "",
      row.message.empty()
          ? ""
          : "<small class=\"message\">" + escaped(row.message) + "</small>");
  for (const double value : row.values)
    text_ += std::isfinite(value)
                 ? fmt::format("<td data-v=\"{}\">{}</td>", value, number_text(value))
                 : "<td data-v=\"\">–</td>";
  text_ += "</tr>\n";
}

}  // namespace blocks::report
