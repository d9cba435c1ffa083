// The factor of safety on the page.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "report/html_text.hpp"
#include "report/page_writer.hpp"

namespace blocks::report {
namespace {

/// Returns the cells from n to the interval.
std::string failure_cells(const FailureCount& count) {
  const Interval interval = count.interval();
  return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
                     "<td class=\"range\">{} to {}</td>",
                     count.failing, count.stable, count.undecided,
                     percent_text(count.share()), percent_text(interval.low),
                     percent_text(interval.high));
}

}  // namespace

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
  if (several_) {
    text_ += "<div class=\"wide\"><table><thead><tr>";
    parameter_heads();
    text_ += "<th>F &lt; 1</th><th>F ≥ 1</th><th>undecided</th><th>share F &lt; 1</th>"
             "<th>95 % interval</th></tr></thead><tbody>\n";
    for (std::size_t g = 0; g < shown_groups(); ++g) {
      text_ += "<tr>";
      parameter_cells(all_.groups[g]);
      text_ += failure_cells(analysis_.groups[g].failure) + "</tr>\n";
    }
    text_ += "</tbody></table></div>\n";
    note_on_groups();
  }
  text_ += "</section>\n";
}

}  // namespace blocks::report
