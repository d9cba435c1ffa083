// Writes columns of numbers as a readable table, or as CSV and JSON for other programs.
#pragma once

#include <string>
#include <vector>

namespace blocks::post {

struct NumberColumn {
  std::string name;                     ///< "speed:9"
  std::string label;                    ///< "speed of block 9"
  std::string unit;                     ///< "m/s", or empty
  std::vector<double> values;           ///< (rows); NaN: no value
  std::string sign = {};                ///< of a stress: "tension positive"
  std::vector<std::string> words = {};  ///< (rows) instead of values
};

/// The columns of one run; all have the same length.
struct NumberTable {
  std::string file, title;
  std::vector<NumberColumn> columns;
};

/// Returns title, signs, names, units, and each number with eight digits; "-" if there
/// is no value.
std::string table_text(const NumberTable& table);

/// Returns names, units, and each number with six digits, in columns as wide as needed.
std::string narrow_table_text(const NumberTable& table);

/// Returns CSV with one header line, in which stresses have their sign: "s22:9 (tension
/// positive)". Numbers are written so that they can be read back
/// exactly; missing values are empty. Several runs follow each other, with the file in
/// a first column `run`. All runs have the same columns.
std::string csv_text(const std::vector<NumberTable>& runs);

/// Returns {"runs": [{"file", "title", "columns": [{"name", "label", "unit", "sign",
/// "values"}]}]}; only stresses have a sign. Missing values are null.
std::string json_text(const std::vector<NumberTable>& runs);

}  // namespace blocks::post
