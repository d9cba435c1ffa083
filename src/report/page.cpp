#include "report/page.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "report/html_text.hpp"
#include "report/page_files.hpp"
#include "report/page_writer.hpp"
#include "report/tables.hpp"

namespace blocks::report {

namespace fs = std::filesystem;

std::string PageWriter::page() {
  outcomes();
  if (!several_)
    key_numbers();
  failures();
  typical_pictures();
  profile();
  parameter_figures();
  sensitivities();
  if (all_.kind() == sweep::Kind::study)
    variant_tables();
  else
    histograms();
  statistics();
  differences();
  run_table();
  const char* const kicker =
      all_.kind() == sweep::Kind::check ? "Statistics of random layers"
      : all_.kind() == sweep::Kind::study
          ? "Statistics of variants of the contact rule in the same frames"
          : "Statistics of a sweep of runs";
  return fmt::format(
      fmt::runtime(page_html), fmt::arg("title", escaped(title())),
      fmt::arg("style", page_css), fmt::arg("kicker", kicker),
      fmt::arg("swept", escaped(capital(sweep_words(all_)))),
      fmt::arg("sections", text_), fmt::arg("precision", analysis_.precision.words()),
      fmt::arg("relative",
               analysis_.precision.relative ? ", as a part of the mean" : ""),
      fmt::arg("facts", facts()), fmt::arg("script", page_js));
}

std::string PageWriter::title() const {
  const std::string own = all_.kind() == sweep::Kind::study ? "Contact detection"
                          : all_.title.empty() ? all_.members.front().plan.name
                                               : all_.title;
  return options_.title.value_or(own);
}

void PageWriter::outcomes() {
  std::size_t ended = 0, done = 0;
  std::vector<OutcomeCount> sums;
  for (const GroupStatistics& group : analysis_.groups) {
    ended += group.ended;
    for (std::size_t i = 0; i < group.outcomes.size(); ++i) {
      if (sums.size() <= i)
        sums.push_back({group.outcomes[i].state, 0, {}});
      sums[i].count += group.outcomes[i].count;
    }
  }
  std::string bar, key;
  for (OutcomeCount& one : sums) {
    if (one.state == State::done)
      done = one.count;
    if (one.count == 0)
      continue;
    bar += fmt::format("<i class=\"{}\" style=\"flex:{}\"></i>", class_of(one.state),
                       one.count);
    std::string share;
    if (one.state != State::open && ended > 0) {
      share = fmt::format(
          " <small>{} (95 % interval {})</small>",
          percent_text(static_cast<double>(one.count) / static_cast<double>(ended)),
          percents_text(wilson(one.count, ended)));
    }
    key += fmt::format("<li><i class=\"{}\"></i>{} {}{}</li>", class_of(one.state),
                       one.count, name_of(one.state), share);
  }
  text_ += "<section>\n<h2>Outcomes</h2>\n<div class=\"outcomes\" "
           "aria-hidden=\"true\">" +
           bar + "</div>\n<ul class=\"key\">" + key + "</ul>\n";
  if (done < all_.rows.size())
    text_ += fmt::format(
        "<p>All statistics on this page are of the {} that are done. The others are "
        "rows of the <a href=\"#runs\">table of runs</a>{}.</p>\n",
        done == 1 ? "one" : std::to_string(done),
        ended < all_.rows.size() ? "; those that are not finished have no outcome yet"
                                 : "");
  if (several_)
    outcome_table();
  text_ += "</section>\n";
}

void PageWriter::key_numbers() {
  constexpr std::size_t max_cards = 6;
  if (analysis_.groups.empty())
    return;
  text_ += "<div class=\"cards\">\n";
  std::size_t cards = 0;
  for (std::size_t c = 0; c < all_.columns.size() && cards < max_cards; ++c) {
    const Column& column = all_.columns[c];
    const ColumnStatistics& found = analysis_.groups.front().columns[c];
    if (found.summary.n == 0)
      continue;
    ++cards;
    const std::string below = column.is_share
                                  ? "95 % interval " + percents_text(found.interval)
                                  : fmt::format("5 to 95 % of the runs: {} to {}",
                                                number_text(found.summary.low.value),
                                                number_text(found.summary.high.value));
    text_ += fmt::format(
        "<div class=\"card\"><b>{}{}</b><span>{}</span><span><small>{}</small>"
        "</span></div>\n",
        column.is_share ? percent_text(found.summary.mean)
                        : mean_text(found.summary.mean, found.interval),
        column.unit.empty() ? "" : " <small>" + escaped(column.unit) + "</small>",
        escaped(column.is_share && column.measure.from == Measure::From::outcome
                    ? "share with " + column.label
                    : capital(column.label)),
        below);
  }
  text_ += "</div>\n<p class=\"note\">Mean over the runs ± half of its 95 % "
           "confidence interval. Definitions are at the <a href=\"#methods\">end of "
           "the page</a>.</p>\n";
}

std::string PageWriter::facts() const {
  std::string rows;
  for (const Member& member : all_.members) {
    rows += fact_row("sweep", fs::absolute(member.folder).lexically_normal().string());
    if (!member.plan.deck.empty())
      rows += fact_row("deck", member.plan.deck);
    rows += fact_row("hash of the deck", member.plan.deck_hash) +
            fact_row("program",
                     "BLOCKS " + member.plan.version + "; " + member.plan.numerics);
  }
  return rows;
}

std::vector<std::size_t> typical_runs(const Ensemble& ensemble,
                                      const Analysis& analysis) {
  std::vector<std::size_t> rows;
  for (std::size_t g = 0; g < ensemble.groups.size() && !ensemble.columns.empty(); ++g)
    if (const auto row = median_run(ensemble, analysis, g, ensemble.main_column()))
      rows.push_back(*row);
  return rows;
}

std::string report_page(const Ensemble& ensemble, const Analysis& analysis,
                        const std::vector<std::size_t>& typical, const RunPages& runs,
                        const PageOptions& options) {
  return PageWriter(ensemble, analysis, typical, runs, options).page();
}

}  // namespace blocks::report
