// Cells of CSV tables, and aligned tables for the terminal.
#pragma once

#include <string>
#include <vector>

#include "report/statistics.hpp"

namespace blocks::report {

/// Quotes a text that contains a comma, a quote or a line break (RFC 4180).
std::string quoted(const std::string& text);

/// Returns the number so that it can be read back exactly; empty if it is not finite.
std::string cell(double value);

/// Returns the number with four digits; "-" if it is not finite.
std::string short_number(double value);

/// Returns "0.1 to 0.2"; "-" if there is no lower end.
std::string short_interval(const Interval& interval);

/// Returns the rows as a table; the first column is aligned to the left. All rows have
/// as many cells as the first one.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace blocks::report
