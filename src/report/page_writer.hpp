// Writes the parts of the page of a report. Private to src/report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/page.hpp"

namespace blocks::report {

/// The width of one of two figures side by side.
inline constexpr const char* half_width = "118mm";

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
  void head();
  /// Sums the outcomes of all groups.
  void outcomes();
  void key_numbers();
  void methods();

  // page_figures.cpp
  void figure(const std::string& picture, const std::string& caption,
              bool caption_first = false);
  /// Returns the heading above the pictures of these rows, and their groups if there
  /// are several.
  std::string typical_heading(const std::vector<std::size_t>& shown) const;
  void typical_pictures();
  void profile();
  void parameter_figures();
  /// Returns "T vertices: 0; X vertices: 0" of the measures that are the same in all
  /// runs, and marks them.
  std::string constants(std::vector<bool>& is_constant) const;
  void histograms();

  // page_tables.cpp
  void outcome_table();
  std::size_t shown_groups() const;
  void note_on_groups();
  void parameter_heads();
  void parameter_cells(const Group& group);
  void statistics_cells(const Column& column, const ColumnStatistics& found);
  void statistics_heads();
  void statistics();
  void differences();
  /// Adds a table of scenes and variants for each share, as in docs/robustness.md.
  void variant_tables();
  std::string share_cell(std::size_t column, const std::string& scene,
                         std::size_t scene_at, const std::string& variant,
                         std::size_t variant_at) const;
  /// Returns the rows of the table of runs: all, or if there are too many the runs that
  /// are not done, the typical and extreme ones, and the first ones.
  std::vector<std::size_t> shown_rows() const;
  void run_table();
  std::string link_words() const;
  void run_row(std::size_t r);

  // page_safety.cpp
  /// Tells in how many runs F < 1, over all groups and in each of them.
  void failures();

  // page_sensitivity.cpp
  /// Shows the Sobol indices of each measure as a figure and a table.
  void sensitivities();
  void index_table(const Sensitivity& one, std::size_t column);

  // page_writer.cpp: words and links
  std::string column_caption(std::size_t c) const;
  std::optional<std::size_t> parameter_index(const std::string& name) const;
  /// A seed of a study is the number of a frame.
  const char* seed_word() const;
  std::string seed_link(std::size_t row) const;
  /// Returns the words as a link to the page of a run, if it has one.
  std::string run_link(std::size_t row, const std::string& words) const;
  std::string link_to(const std::string& file) const;
  /// Returns the first measure that is not a share, or 0.
  std::size_t main_column() const;

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
