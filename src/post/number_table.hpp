// Columns of numbers as a table for the eye, CSV and JSON for other programs.
#pragma once

#include <string>
#include <vector>

namespace blocks::post {

struct NumberColumn {
  std::string name;            ///< "speed:9"
  std::string label;           ///< "speed of block 9"
  std::string unit;            ///< "m/s", or empty
  std::vector<double> values;  ///< (rows); NaN: no number
};

/// Columns of equal length, of one run.
struct NumberTable {
  std::string file, title;
  std::vector<NumberColumn> columns;
};

/// Title, names, units, and eight digits of each number; "-" for none.
std::string table_text(const NumberTable& table);

/// One header line; numbers that read back bit for bit, nothing between the commas for
/// none. Several runs stand below each other with the file in a first column `run`.
/// Runs have the same columns.
std::string csv_text(const std::vector<NumberTable>& runs);

/// {"runs": [{"file", "title", "columns": [{"name", "label", "unit", "values"}]}]};
/// null for no number.
std::string json_text(const std::vector<NumberTable>& runs);

}  // namespace blocks::post
