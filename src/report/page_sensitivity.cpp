// The Sobol indices on the page.
#include <fmt/format.h>

#include <cmath>

#include "report/charts.hpp"
#include "report/html_text.hpp"
#include "report/page_writer.hpp"

namespace blocks::report {
namespace {

/// Returns the cells of an index and its interval.
std::string index_cells(double value, const Interval& interval) {
  if (!std::isfinite(value))
    return "<td>–</td><td class=\"range\">–</td>";
  return fmt::format("<td>{:.3f}</td><td class=\"range\">{:.3f} to {:.3f}</td>", value,
                     interval.low, interval.high);
}

}  // namespace

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
    text_ += "<div class=\"pair\">\n";
    for (std::size_t c = 0; c < all_.columns.size(); ++c)
      if (const draw::DotChart chart = index_chart(all_, one, c); !chart.names.empty())
        figure(draw::chart_svg(chart, draw::PageSize::in_print(half_width)),
               column_caption(c) + ". " + rows_words(one.quantities[c]) + ".", true);
    text_ += "</div>\n";
    for (std::size_t c = 0; c < all_.columns.size(); ++c)
      index_table(one, c);
  }
  text_ += "</section>\n";
}

void PageWriter::index_table(const Sensitivity& one, std::size_t column) {
  const SobolIndices& indices = one.quantities[column];
  text_ += fmt::format(
      "<h3>{}</h3>\n<p class=\"note\">{}</p>\n<div class=\"wide\"><table><thead><tr>"
      "<th class=\"text\">parameter</th><th>first order</th><th>95 % interval</th>"
      "<th>total</th><th>95 % interval</th></tr></thead><tbody>\n",
      escaped(capital(all_.columns[column].label)), rows_words(indices));
  for (std::size_t i = 0; i < one.parameters.size(); ++i) {
    const SobolIndex& index = indices.parameters[i];
    text_ += "<tr><th scope=\"row\">" + escaped(one.parameters[i]) + "</th>" +
             index_cells(index.first, index.first_interval) +
             index_cells(index.total, index.total_interval) + "</tr>\n";
  }
  text_ += "</tbody></table></div>\n";
}

}  // namespace blocks::report
