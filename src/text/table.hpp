// Tables of texts: aligned for a terminal, and cells of CSV.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace blocks::text {

/// Returns the number of characters of a UTF-8 text, which is its width on a terminal.
std::size_t width_of(std::string_view text);

/// Returns the rows as lines with two blanks between columns and none at the end. The
/// columns from `right` on, counted from 0, are aligned to the right. A row of one cell
/// is a heading, which makes no column wider; other rows have all columns.
std::string aligned(const std::vector<std::vector<std::string>>& rows,
                    std::size_t right);

/// Returns a cell of CSV: in quotes if it contains a comma, a quote or a line break
/// (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace blocks::text
