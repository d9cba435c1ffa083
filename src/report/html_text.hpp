// Texts of HTML pages: escaped words, numbers as people write them, and tables.
#pragma once

#include <string>
#include <vector>

#include "report/statistics.hpp"
#include "text/escaped.hpp"

namespace blocks::report {

using text::escaped;

/// Returns the text as part of a URL of a file: everything except letters, digits and
/// "-_.~/" is written as %XX.
std::string url_of(const std::string& path);

/// Returns a number with four digits: "−0.1230", "1.235×10⁶"; whole numbers, and those
/// from 1,000 to 100,000, without decimals; "–" if it is not finite.
std::string number_text(double value);

/// Returns "low to high"; "–" if there is no interval. An end that does not exist is
/// written as "…".
std::string interval_text(const Interval& interval);

/// Returns "mean ± half width", both with the decimals that two digits of the half
/// width need; the mean alone if there is no interval.
std::string mean_text(double mean, const Interval& interval);

/// Returns a share in percent with one decimal: "95 %", "0.4 %"; at least 0.1 % unless
/// it is 0.
std::string percent_text(double share);

/// Returns the ends of an interval of a share in percent: "4.2 % to 31 %".
std::string percents_text(const Interval& interval);

/// Returns bytes as base64 (RFC 4648).
std::string base64(const std::string& bytes);

/// Returns an SVG picture for a page with several of them: without XML declaration, and
/// with its identifiers preceded by `prefix`. Other texts remain.
std::string unique_ids(std::string svg, const std::string& prefix);

/// Returns a row of a table of facts. The texts are escaped.
std::string fact_row(const std::string& name, const std::string& value);

/// A table of a page, which scrolls if it is wide. Its texts are HTML. Marks are
/// attributes of HTML, and hold for one cell.
class HtmlTable {
 public:
  static constexpr const char* left = "class=\"text\"";    ///< aligned to the left
  static constexpr const char* range = "class=\"range\"";  ///< an interval

  void head(const std::string& text, const std::string& marks = {});
  void heads(const std::vector<std::string>& texts);
  /// Begins a row.
  void row(const std::string& marks = {});
  void row_head(const std::string& text);
  void cell(const std::string& text, const std::string& marks = {});
  void cells(const std::vector<std::string>& texts);
  std::string html() const;

 private:
  std::string heads_, rows_;
};

}  // namespace blocks::report
