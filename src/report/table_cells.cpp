#include "report/table_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blocks::report {
namespace {

/// Returns the width on a terminal: the number of bytes that begin a character.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::size_t own = width_of(text);
  const std::string space(own < width ? width - own : 0, ' ');
  return right ? space + text : text + space;
}

}  // namespace

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string safe = "\"";
  for (const char c : text)
    safe += c == '"' ? "\"\"" : std::string(1, c);
  return safe + '"';
}

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value + 0.0) : "";
}

std::string short_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value + 0.0) : "-";
}

std::string short_interval(const Interval& interval) {
  return std::isfinite(interval.low)
             ? short_number(interval.low) + " to " + short_number(interval.high)
             : "-";
}

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c)
      widths[c] = std::max(widths[c], width_of(row[c]));
  std::string text;
  for (const auto& row : rows) {
    std::string line = "  ";
    for (std::size_t c = 0; c < row.size(); ++c)
      line += padded(row[c], widths[c], c > 0) + (c + 1 < row.size() ? "  " : "");
    text += line + '\n';
  }
  return text;
}

}  // namespace blocks::report
