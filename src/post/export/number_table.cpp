#include "post/export/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace blocks::post {
namespace {

std::size_t rows(const NumberTable& table) {
  return table.columns.empty() ? 0 : table.columns.front().values.size();
}

/// Returns the width on a terminal: the number of bytes that begin a character.
std::size_t places(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string right(const std::string& text, std::size_t width) {
  const std::size_t own = places(text);
  return std::string(own < width ? width - own : 0, ' ') + text;
}

/// Quotes a name that contains a comma or a quote.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos)
    return text;
  std::string safe = "\"";
  for (const char c : text)
    safe += c == '"' ? "\"\"" : std::string(1, c);
  return safe + '"';
}

std::string name_with_sign(const NumberColumn& column) {
  return column.sign.empty() ? column.name : column.name + " (" + column.sign + ")";
}

}  // namespace

std::string table_text(const NumberTable& table) {
  const auto stress = std::find_if(table.columns.begin(), table.columns.end(),
                                   [](const auto& c) { return !c.sign.empty(); });
  std::string text = fmt::format(
      "{} ({}){}\n", table.title, table.file,
      stress == table.columns.end() ? "" : ", stresses are " + stress->sign);
  std::string names, units;
  bool any_unit = false;
  std::vector<std::size_t> widths;
  for (const NumberColumn& column : table.columns) {
    widths.push_back(std::max<std::size_t>(14, places(column.name)) + 2);
    names += right(column.name, widths.back());
    units += right(column.unit, widths.back());
    any_unit = any_unit || !column.unit.empty();
  }
  text += names + '\n' + (any_unit ? units + '\n' : "");
  for (std::size_t i = 0; i < rows(table); ++i) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const double value = table.columns[c].values[i];
      text += right(std::isnan(value) ? "-" : fmt::format("{:.8g}", value + 0.0),
                    widths[c]);
    }
    text += '\n';
  }
  return text;
}

std::string narrow_table_text(const NumberTable& table) {
  const auto entry = [](const NumberColumn& column, std::size_t i) {
    return column.words.empty() ? fmt::format("{:g}", column.values[i] + 0.0)
                                : column.words[i];
  };
  std::string names, units;
  std::vector<std::size_t> widths;
  for (const NumberColumn& column : table.columns) {
    std::size_t width = std::max(places(column.name), places(column.unit));
    for (std::size_t i = 0; i < rows(table); ++i)
      width = std::max(width, places(entry(column, i)));
    widths.push_back(width + (widths.empty() ? 0 : 2));
    names += right(column.name, widths.back());
    units += right(column.unit, widths.back());
  }
  std::string text = names + '\n' + units + '\n';
  for (std::size_t i = 0; i < rows(table); ++i) {
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      text += right(entry(table.columns[c], i), widths[c]);
    text += '\n';
  }
  return text;
}

std::string csv_text(const std::vector<NumberTable>& runs) {
  const bool several = runs.size() > 1;
  std::string text = several ? "run," : "";
  for (std::size_t c = 0; c < runs.front().columns.size(); ++c)
    text += (c ? "," : "") + quoted(name_with_sign(runs.front().columns[c]));
  text += '\n';
  for (const NumberTable& run : runs)
    for (std::size_t i = 0; i < rows(run); ++i) {
      if (several)
        text += quoted(run.file) + ',';
      for (std::size_t c = 0; c < run.columns.size(); ++c) {
        const NumberColumn& column = run.columns[c];
        text += c ? "," : "";
        if (!column.words.empty())
          text += quoted(column.words[i]);
        else if (!std::isnan(column.values[i]))
          text += fmt::format("{}", column.values[i] + 0.0);
      }
      text += '\n';
    }
  return text;
}

std::string json_text(const std::vector<NumberTable>& runs) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const NumberTable& run : runs) {
    Json columns = Json::array();
    for (const NumberColumn& column : run.columns) {
      Json one = {
          {"name", column.name}, {"label", column.label}, {"unit", column.unit}};
      if (!column.sign.empty())
        one["sign"] = column.sign;
      if (column.words.empty())
        one["values"] = column.values;  // values that are not finite become null
      else
        one["values"] = column.words;
      columns.push_back(std::move(one));
    }
    list.push_back({{"file", run.file}, {"title", run.title}, {"columns", columns}});
  }
  return Json{{"runs", list}}.dump(1, ' ', false, Json::error_handler_t::replace) +
         '\n';
}

}  // namespace blocks::post
