#include "report/html_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "draw/number_text.hpp"

namespace blocks::report {
namespace {

constexpr const char* no_value = "–";

/// Replaces hyphens by minus signs.
std::string with_minus(std::string text) {
  for (auto at = text.find('-'); at != text.npos; at = text.find('-', at + 1))
    text.replace(at, 1, "−");
  return text;
}

/// Writes 1e+06 as 1×10⁶.
std::string with_power(const std::string& text) {
  const auto e = text.find('e');
  return e == std::string::npos ? with_minus(text)
                                : with_minus(text.substr(0, e)) + "×10" +
                                      draw::superscript(std::stoi(text.substr(e + 1)));
}

void put_before_names(std::string& text, const std::string& mark,
                      const std::string& prefix) {
  for (auto at = text.find(mark); at != text.npos;
       at = text.find(mark, at + mark.size()))
    text.insert(at + mark.size(), prefix);
}

/// Returns an element of HTML with these attributes.
std::string element(const std::string& name, const std::string& text,
                    const std::string& marks) {
  return '<' + name + (marks.empty() ? "" : " " + marks) + '>' + text + "</" + name +
         '>';
}

}  // namespace

std::string url_of(const std::string& path) {
  std::string url;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || std::string("-_.~/").find(c) != std::string::npos)
      url += c;
    else
      url += fmt::format("%{:02X}", byte);
  }
  return url;
}

std::string number_text(double value) {
  if (!std::isfinite(value))
    return no_value;
  constexpr double max_whole = 1e7, max_fixed = 1e5, min_long = 1e3;
  const double size = std::abs(value);
  if ((value == std::round(value) && size < max_whole) ||
      (size >= min_long && size < max_fixed))
    return with_minus(fmt::format("{:.0f}", value + 0.0));
  return with_power(fmt::format("{:#.4g}", value));
}

std::string interval_text(const Interval& interval) {
  const bool low = std::isfinite(interval.low), high = std::isfinite(interval.high);
  if (!low && !high)
    return no_value;
  return (low ? number_text(interval.low) : "…") + " to " +
         (high ? number_text(interval.high) : "…");
}

std::string mean_text(double mean, const Interval& interval) {
  if (!std::isfinite(interval.low))
    return number_text(mean);
  constexpr double large = 1e5, small = 1e-4;
  const double half = 0.5 * (interval.high - interval.low);
  const double size = std::max(std::abs(mean), half);
  if (half == 0.0)
    return number_text(mean) + " ± 0";
  if (size >= large || size < small) {
    const double power = std::floor(std::log10(size)), unit = std::pow(10.0, power);
    const int decimals =
        std::clamp(static_cast<int>(1 - std::floor(std::log10(half / unit))), 0, 6);
    return with_minus(fmt::format("({:.{}f} ± {:.{}f})", mean / unit, decimals,
                                  half / unit, decimals)) +
           "×10" + draw::superscript(static_cast<int>(power));
  }
  const int decimals =
      std::clamp(static_cast<int>(1 - std::floor(std::log10(half))), 0, 9);
  return with_minus(fmt::format("{:.{}f} ± {:.{}f}", mean, decimals, half, decimals));
}

std::string percent_text(double share) {
  if (!std::isfinite(share))
    return no_value;
  const double percent = std::round(1000.0 * share) / 10.0;
  return fmt::format("{:g} %", percent == 0.0 && share > 0.0 ? 0.1 : percent);
}

std::string percents_text(const Interval& interval) {
  return percent_text(interval.low) + " to " + percent_text(interval.high);
}

std::string base64(const std::string& bytes) {
  static constexpr char letters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * (bytes.size() + 2) / 3);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned long group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U |
              (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[group >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

std::string unique_ids(std::string svg, const std::string& prefix) {
  const auto begin = svg.find("<svg");
  if (begin == std::string::npos)
    return svg;
  svg.erase(0, begin);
  for (const char* mark : {" id=\"", "url(#", "href=\"#"})
    put_before_names(svg, mark, prefix);
  return svg;
}

std::string fact_row(const std::string& name, const std::string& value) {
  return "<tr>" + element("th", escaped(name), "scope=\"row\"") +
         element("td", escaped(value), {}) + "</tr>\n";
}

void HtmlTable::head(const std::string& text, const std::string& marks) {
  heads_ += element("th", text, marks);
}

void HtmlTable::heads(const std::vector<std::string>& texts) {
  for (const std::string& text : texts)
    head(text);
}

void HtmlTable::row(const std::string& marks) {
  rows_ += rows_.empty() ? "<tr" : "</tr>\n<tr";
  rows_ += (marks.empty() ? "" : " " + marks) + '>';
}

void HtmlTable::row_head(const std::string& text) {
  rows_ += element("th", text, "scope=\"row\"");
}

void HtmlTable::cell(const std::string& text, const std::string& marks) {
  rows_ += element("td", text, marks);
}

void HtmlTable::cells(const std::vector<std::string>& texts) {
  for (const std::string& text : texts)
    cell(text);
}

std::string HtmlTable::html() const {
  return "<div class=\"wide\"><table><thead><tr>" + heads_ + "</tr></thead><tbody>\n" +
         rows_ + (rows_.empty() ? "" : "</tr>\n") + "</tbody></table></div>\n";
}

}  // namespace blocks::report
