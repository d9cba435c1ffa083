#include "report/page.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "report/html_text.hpp"
#include "report/page_style.hpp"
#include "report/page_writer.hpp"
#include "report/tables.hpp"

namespace blocks::report {

namespace fs = std::filesystem;

std::string PageWriter::page() {
  head();
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
  methods();
  text_ +=
      fmt::format("</main>\n<script>\n{}</script>\n</body>\n</html>\n", page_script);
  return std::move(text_);
}

std::string PageWriter::title() const {
  const std::string own = all_.kind() == sweep::Kind::study ? "Contact detection"
                          : all_.title.empty() ? all_.members.front().plan.name
                                               : all_.title;
  return options_.title.value_or(own);
}

void PageWriter::head() {
  text_ += fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<main>\n<header>\n"
      "<p class=\"kicker\">{2}</p>\n<h1>{0}</h1>\n<p class=\"swept\">{3}.</p>\n"
      "</header>\n",
      escaped(title()), page_style,
      all_.kind() == sweep::Kind::check ? "Statistics of random layers"
      : all_.kind() == sweep::Kind::study
          ? "Statistics of variants of the contact rule in the same frames"
          : "Statistics of a sweep of runs",
      escaped(capital(sweep_words(all_))));
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
      const Interval w = wilson(one.count, ended);
      share = fmt::format(
          " <small>{} (95 % interval {} to {})</small>",
          percent_text(static_cast<double>(one.count) / static_cast<double>(ended)),
          percent_text(w.low), percent_text(w.high));
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
  constexpr std::size_t most_cards = 6;
  if (analysis_.groups.empty())
    return;
  text_ += "<div class=\"cards\">\n";
  std::size_t cards = 0;
  for (std::size_t c = 0; c < all_.columns.size() && cards < most_cards; ++c) {
    const Column& column = all_.columns[c];
    const ColumnStatistics& found = analysis_.groups.front().columns[c];
    if (found.summary.n == 0)
      continue;
    ++cards;
    const std::string below =
        column.is_share
            ? fmt::format("95 % interval {} to {}", percent_text(found.interval.low),
                          percent_text(found.interval.high))
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

void PageWriter::methods() {
  text_ += "<section id=\"methods\">\n<h2>Definitions</h2>\n<dl>\n";
  const auto define = [&](const std::string& term, const std::string& meaning) {
    text_ += "<dt>" + term + "</dt><dd>" + meaning + "</dd>\n";
  };
  define("n", "Number of runs that are done and have a value.");
  define("mean ± 95 %", "Mean, and half of its 95 % confidence interval by Student's t "
                        "distribution with n − 1 degrees of freedom. It assumes that "
                        "the means of such samples are normally distributed.");
  define("sd", "Standard deviation of the runs, with the divisor n − 1.");
  define("5 %, median, 95 %",
         "Quantiles of the runs: the value at the place 1 + p (n − 1) of the sorted "
         "values, interpolated. Their 95 % intervals are order statistics by the "
         "binomial distribution and hold for any distribution; … means that there are "
         "too few runs for that end.");
  define("interval of a share",
         "Wilson's score interval, 95 %. It is of use for 0 or all of n runs, too.");
  define("runs for ± " + analysis_.precision.words(),
         std::string("Number of runs for which the 95 % interval of the mean would be "
                     "this narrow") +
             (analysis_.precision.relative ? ", as a part of the mean" : "") +
             ", if the standard deviation remains the same.");
  text_ += "</dl>\n<h2>How to repeat it</h2>\n<table class=\"facts\">\n";
  const auto fact = [&](const std::string& name, const std::string& value) {
    text_ +=
        "<tr><th scope=\"row\">" + name + "</th><td>" + escaped(value) + "</td></tr>\n";
  };
  for (const Member& member : all_.members) {
    fact("sweep", fs::absolute(member.folder).lexically_normal().string());
    if (!member.plan.deck.empty())
      fact("deck", member.plan.deck);
    fact("hash of the deck", member.plan.deck_hash);
    fact("program", "BLOCKS " + member.plan.version + "; " + member.plan.numerics);
  }
  text_ += "</table>\n<p class=\"note\">Runs with the same deck, seed, parameters, "
           "version and numerics give the same results to the last bit, whatever the "
           "computer, the number of threads, or the engine of the sweep.</p>\n"
           "</section>\n";
}

std::vector<std::size_t> typical_runs(const Ensemble& ensemble,
                                      const Analysis& analysis) {
  std::size_t column = 0;
  while (column < ensemble.columns.size() && ensemble.columns[column].is_share)
    ++column;
  column = column < ensemble.columns.size() ? column : 0;
  std::vector<std::size_t> rows;
  for (std::size_t g = 0; g < ensemble.groups.size() && !ensemble.columns.empty(); ++g)
    if (const auto row = median_run(ensemble, analysis, g, column))
      rows.push_back(*row);
  return rows;
}

std::string report_page(const Ensemble& ensemble, const Analysis& analysis,
                        const std::vector<std::size_t>& typical, const RunPages& runs,
                        const PageOptions& options) {
  return PageWriter(ensemble, analysis, typical, runs, options).page();
}

}  // namespace blocks::report
