// The figures of the page, with their captions.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "report/charts.hpp"
#include "report/html_text.hpp"
#include "report/page_writer.hpp"
#include "report/pictures.hpp"

namespace blocks::report {
namespace {

std::string run_name(const RunRow& row) {
  return row.seed ? fmt::format("run {} (seed {})", row.id, *row.seed)
                  : fmt::format("run {}", row.id);
}

/// The widths of a figure, and of one of two side by side.
constexpr const char *whole = "240mm", *half_width = "118mm";

/// Puts figures side by side.
std::string in_pairs(const std::string& figures) {
  return "<div class=\"pair\">\n" + figures + "</div>\n";
}

/// Returns a chart as SVG; empty if it has nothing to show.
std::string svg(const draw::Chart& chart, const char* width) {
  return chart.panels.empty() ? std::string()
                              : draw::chart_svg(chart, draw::PageSize::in_print(width));
}

}  // namespace

std::string PageWriter::figure(const std::string& picture, const std::string& caption,
                               bool caption_first) {
  if (picture.empty())
    return {};
  const std::string words = "<figcaption>" + caption + "</figcaption>";
  return "<figure>" + (caption_first ? words : "") +
         unique_ids(picture, fmt::format("f{}-", ++figures_)) +
         (caption_first ? "" : words) + "</figure>\n";
}

std::string PageWriter::typical_heading(const std::vector<std::size_t>& shown) const {
  if (shown.size() == 1)
    return "<h2>A typical run</h2>\n";
  const auto group_of = [&](std::size_t r) {
    return escaped(all_.name_of(all_.groups[all_.rows[r].group]));
  };
  return fmt::format(
      "<h2>Typical runs</h2>\n<p>The pictures show a run with {} and a run with "
      "{}{}.</p>\n",
      group_of(shown.front()), group_of(shown.back()),
      typical_.size() > 2
          ? fmt::format(", the first and the last of {} groups", typical_.size())
          : "");
}

std::string PageWriter::typical_figure(std::size_t r) {
  const RunRow& row = all_.rows[r];
  std::string picture;
  try {
    if (row.has_results)
      picture =
          first_and_last(all_, row, all_.profile ? all_.profile->mirror : std::nullopt);
  } catch (const std::runtime_error&) {
    return {};  // the results are damaged; the table of runs says so
  }
  const std::size_t c = all_.main_column();
  const std::string name = all_.name_of(all_.groups[row.group]);
  const std::string unit = escaped(all_.columns[c].unit);
  const Summary& summary = analysis_.groups[row.group].columns[c].summary;
  return figure(picture,
                fmt::format("The first and the last state of {}{}{}: its {} of {} is "
                            "nearest to the median, {}, of the {} runs.",
                            run_link(r, run_name(row)), name.empty() ? "" : ", ",
                            escaped(name), escaped(all_.columns[c].label),
                            number_with_unit(number_text(row.values[c]), unit),
                            number_with_unit(number_text(summary.median.value), unit),
                            summary.n));
}

void PageWriter::typical_pictures() {
  if (all_.kind() != sweep::Kind::run || typical_.empty())
    return;
  // More than two would hide the figures below.
  std::vector<std::size_t> shown = {typical_.front()};
  if (typical_.size() > 1)
    shown.push_back(typical_.back());
  std::string figures;
  for (const std::size_t r : shown)
    figures += typical_figure(r);
  if (!figures.empty())
    text_ += "<section>\n" + typical_heading(shown) + figures + "</section>\n";
}

void PageWriter::profile() {
  const std::string picture = svg(profile_chart(all_, analysis_), whole);
  if (picture.empty())
    return;
  const ProfileQuestion& question = *all_.profile;
  const std::string label = quantities::find_quantity(question.quantity)->label;
  const std::string where =
      question.line.segment ? "along the line" : "of the blocks at the upper surface";
  std::size_t fewest = all_.rows.size();
  for (const GroupStatistics& group : analysis_.groups)
    if (group.profile)
      fewest = std::min(fewest, group.profile->runs);
  const std::string caption = fmt::format(
      "{} {} {}. At each position, the line is the median over the runs, and 90 % of "
      "the runs lie within the band (5 and 95 % quantiles). The median is not the "
      "profile of any single run.{}",
      escaped(capital(label)), where,
      question.time
          ? "at " + escaped(post::time_text(*question.time, std::nullopt, all_.units))
          : "at the end of the runs",
      fewest < 20 ? " With fewer than 20 runs the band is little more than the "
                    "extremes."
                  : "");
  text_ += fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n",
                       question.line.segment ? "Profile along the line"
                                             : "Profile of the upper surface",
                       figure(picture, caption));
}

std::string PageWriter::chart_figures(draw::Chart (*chart)(const Ensemble&,
                                                           const Analysis&,
                                                           std::size_t),
                                      const std::vector<bool>& left_out) {
  std::string figures;
  for (std::size_t c = 0; c < all_.columns.size(); ++c)
    if (left_out.empty() || !left_out[c])
      figures +=
          figure(svg(chart(all_, analysis_, c), half_width), column_caption(c), true);
  return figures.empty() ? figures : in_pairs(figures);
}

void PageWriter::parameter_figures() {
  if (analysis_.axis.empty())
    return;
  text_ += "<section>\n<h2>Effect of " + escaped(all_.parameters[*analysis_.compared]) +
           "</h2>\n<p>Means over the seeds with their 95 % confidence "
           "intervals.</p>\n" +
           chart_figures(against_parameter);
  if (const std::string figures = chart_figures(report::differences); !figures.empty())
    text_ += "<p>Differences from the first value, taken seed by seed. What a seed "
             "changes with every value cancels out.</p>\n" +
             figures;
  text_ += "</section>\n";
}

void PageWriter::sensitivities() {
  if (analysis_.sensitivities.empty())
    return;
  text_ +=
      "<section>\n<h2>Sensitivity</h2>\n<p>The first-order Sobol index of a "
      "parameter is the part of the variance that it causes alone. The total index "
      "also has the part that it causes together with others. The parameters are "
      "independent of each other, each with a uniform distribution.</p>\n";
  for (const Sensitivity& one : analysis_.sensitivities) {
    if (several_)
      text_ += "<h3>" + escaped(all_.name_of(all_.groups[one.group])) + "</h3>\n";
    std::string figures;
    for (std::size_t c = 0; c < all_.columns.size(); ++c)
      if (const draw::DotChart chart = index_chart(all_, one, c); !chart.names.empty())
        figures += figure(
            draw::chart_svg(chart, draw::PageSize::in_print(half_width)),
            column_caption(c) + ". " + rows_words(one.quantities[c]) + ".", true);
    text_ += in_pairs(figures);
    for (std::size_t c = 0; c < all_.columns.size(); ++c)
      index_table(one, c);
  }
  text_ += "</section>\n";
}

std::string PageWriter::constants(std::vector<bool>& is_constant) const {
  std::string words;
  for (std::size_t c = 0; c < all_.columns.size(); ++c) {
    double min = std::numeric_limits<double>::infinity(), max = -min;
    std::size_t n = 0;
    for (const GroupStatistics& group : analysis_.groups)
      if (const Summary& s = group.columns[c].summary; s.n > 0) {
        min = std::min(min, s.min);
        max = std::max(max, s.max);
        n += s.n;
      }
    if (n < 2 || min < max || all_.columns[c].is_share)
      continue;
    is_constant[c] = true;
    words += fmt::format(
        "{}{}: {}", words.empty() ? "" : "; ", escaped(all_.columns[c].label),
        number_with_unit(number_text(min), escaped(all_.columns[c].unit)));
  }
  return words;
}

void PageWriter::histograms() {
  std::vector<bool> is_constant(all_.columns.size(), false);
  const std::string the_same = constants(is_constant);
  const std::string figures = chart_figures(histogram, is_constant);
  if (figures.empty() && the_same.empty())
    return;
  text_ += "<section>\n<h2>Distributions</h2>\n";
  if (!figures.empty())
    text_ += "<p>Each bar counts runs. The dashed line is the median." +
             (all_.groups.size() > max_groups_drawn
                  ? fmt::format(" {} of {} groups are drawn.", max_groups_drawn,
                                all_.groups.size())
                  : "") +
             "</p>\n" + figures;
  if (!the_same.empty())
    text_ += "<p>The same in all runs: " + the_same + ".</p>\n";
  text_ += "</section>\n";
}

}  // namespace blocks::report
