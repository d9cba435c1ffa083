// Writes the parts of the page of a report. Private to src/report.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "draw/chart/line_chart.hpp"
#include "report/html_text.hpp"
#include "report/page.hpp"

namespace blocks::report {

/// Returns the text with a capital first letter.
std::string capital(std::string text);

/// Returns "text unit", or the text if there is no unit.
std::string number_with_unit(const std::string& text, const std::string& unit);

/// Returns the state as the name of a CSS class.
std::string class_of(State state);

/// The arguments of its constructor must exist as long.
class PageWriter {
 public:
  PageWriter(const Ensemble& ensemble, const Analysis& analysis,
             const std::vector<std::size_t>& typical, const RunPages& runs,
             const PageOptions& options)
      : all_(ensemble), analysis_(analysis), typical_(typical), runs_(runs),
        options_(options), several_(ensemble.groups.size() > 1) {}

  /// Returns the page; call it once.
  std::string page();

 private:
  // page.cpp
  std::string title() const;
  /// Sums the outcomes of all groups.
  void outcomes();
  void key_numbers();
  /// Returns what is needed to repeat the sweeps, as rows of a table.
  std::string facts() const;

  // page_figures.cpp
  std::string figure(const std::string& picture, const std::string& caption,
                     bool caption_first = false);
  /// Returns the heading above the pictures of these rows, and their groups if there
  /// are several.
  std::string typical_heading(const std::vector<std::size_t>& shown) const;
  std::string typical_figure(std::size_t r);
  void typical_pictures();
  void profile();
  /// Returns the charts of all columns that are not left out, side by side; empty if
  /// none has anything to show.
  std::string chart_figures(draw::Chart (*chart)(const Ensemble&, const Analysis&,
                                                 std::size_t),
                            const std::vector<bool>& left_out = {});
  void parameter_figures();
  /// Shows the Sobol indices of each measure as a figure and a table.
  void sensitivities();
  /// Returns "T vertices: 0; X vertices: 0" of the measures that are the same in all
  /// runs, and marks them.
  std::string constants(std::vector<bool>& is_constant) const;
  void histograms();

  // page_tables.cpp
  void parameter_heads(HtmlTable& table, const std::string& marks = {}) const;
  void parameter_cells(HtmlTable& table, const Group& group) const;
  std::size_t shown_groups() const;
  /// Adds a table with a row for each group: its parameters, and what `cells` adds.
  void group_table(const std::vector<std::string>& heads,
                   const std::function<void(HtmlTable&, std::size_t)>& cells);
  void outcome_table();
  /// Tells in how many runs F < 1, over all groups and in each of them.
  void failures();
  void statistics_cells(HtmlTable& table, const Column& column,
                        const ColumnStatistics& found) const;
  void statistics();
  void differences();
  /// Adds a table of scenes and variants for each share, as in docs/robustness.md.
  void variant_tables();
  /// Returns the share of the first group that is meant and has one.
  std::string share_text(std::size_t column,
                         const std::function<bool(const Group&)>& is_meant) const;
  void index_table(const Sensitivity& one, std::size_t column);
  /// Returns the rows of the table of runs: all, or if there are too many the runs that
  /// are not done, the typical and extreme ones, and the first ones.
  std::vector<std::size_t> shown_rows() const;
  void run_table();
  void run_row(HtmlTable& table, std::size_t r) const;

  // page_writer.cpp: words and links
  std::string column_caption(std::size_t c) const;
  std::optional<std::size_t> parameter_index(const std::string& name) const;
  /// A seed of a study is the number of a frame.
  const char* seed_word() const;
  std::string seed_link(std::size_t row) const;
  /// Returns the words as a link to the page of a run, if it has one.
  std::string run_link(std::size_t row, const std::string& words) const;
  std::string link_to(const std::string& file) const;

  const Ensemble& all_;
  const Analysis& analysis_;
  const std::vector<std::size_t>& typical_;
  const RunPages& runs_;
  const PageOptions& options_;
  const bool several_;
  std::string text_;
  int figures_ = 0;
  bool shares_shown_ = false;  ///< in tables of their own
};

}  // namespace blocks::report
