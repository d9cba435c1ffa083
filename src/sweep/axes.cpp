#include "sweep/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "text/number.hpp"

namespace blocks::sweep {
namespace {

std::uint64_t parse_seed(const std::string& text) {
  const std::string word = trimmed(text);
  const auto seed = text::number_of<std::uint64_t>(word);
  if (!seed || *seed > largest_seed)
    throw AxisFault(fmt::format("a seed is a whole number from 0 to {}, found '{}'",
                                largest_seed, word),
                    "write seeds as 1-200 or 1,5,9");
  return *seed;
}

[[noreturn]] void refuse_number_of_runs() {
  throw AxisFault(fmt::format("a sweep has at most {} runs", max_runs),
                  "make several sweeps, each with some of the seeds");
}

/// Splits at commas that are not in quotes.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  char quote = 0;  // the open one
  for (const char c : text) {
    if (quote == 0 && (c == '"' || c == '\''))
      quote = c;
    else if (c == quote)
      quote = 0;
    if (c == ',' && quote == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// Whether two values are the same text, or the same number: .3 and 0.30.
bool is_same_value(const std::string& a, const std::string& b) {
  const auto number = [](const std::string& text) {
    return text::number_of<double>(text.substr(text.starts_with('+') ? 1 : 0));
  };
  return a == b || (number(a) && number(a) == number(b));
}

/// The rows of a CSV text: fields in double quotes may have commas and line ends.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool quoted = false;
  const std::string mark = "\xEF\xBB\xBF";  // of UTF-8, which some programs write
  for (std::size_t i = text.starts_with(mark) ? mark.size() : 0; i < text.size(); ++i) {
    const char c = text[i];
    std::string& field = rows.back().back();
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
      field += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (quoted)
      field += c;
    else if (c == ',')
      rows.back().emplace_back();
    else if (c == '\n')
      rows.emplace_back(1);
    else
      field += c;
  }
  if (quoted)
    throw AxisFault("a quote in the table of parameters is not closed",
                    "write a quote inside a value as two quotes");
  for (auto& row : rows)
    for (std::string& field : row)
      field = trimmed(field);
  return rows;
}

bool is_empty(const std::vector<std::string>& row) {
  return row.size() == 1 && row.front().empty();
}

}  // namespace

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r");
  return begin == std::string::npos
             ? std::string()
             : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

bool is_field(const std::string& name) {
  const auto dot = name.find('.');
  return dot != std::string::npos && dot > 0 && dot + 1 < name.size() &&
         name.find_first_of("= \t\n") == std::string::npos;
}

std::vector<std::uint64_t> parse_seeds(const std::string& text) {
  std::vector<std::uint64_t> seeds;
  for (const std::string& part : split(text)) {
    const auto dash = part.find('-', 1);
    const std::uint64_t first = parse_seed(part.substr(0, dash));
    const std::uint64_t last =
        dash == std::string::npos ? first : parse_seed(part.substr(dash + 1));
    if (last < first)
      throw AxisFault(fmt::format("the seeds {} end before they begin", trimmed(part)),
                      fmt::format("write them as {}-{}", last, first));
    if (last - first >= max_runs || seeds.size() + (last - first) >= max_runs)
      refuse_number_of_runs();
    for (std::uint64_t seed = first; seed <= last; ++seed)
      seeds.push_back(seed);
  }
  std::vector<std::uint64_t> sorted = seeds;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end())
    throw AxisFault(fmt::format("the seed {} is given twice", *twice),
                    "two runs with one seed are the same run: name each seed once");
  return seeds;
}

Axis parse_axis(const std::string& text) {
  const auto equals = text.find('=');
  Axis axis{trimmed(text.substr(0, equals)), {}};
  if (equals == std::string::npos || !is_field(axis.field))
    throw AxisFault(
        fmt::format("--set: expected CARD.field=value,value, found '{}'", text),
        "for example --set FRICTN.fric=.3,.5; 'blocks cards --set DECK' lists the "
        "fields of a deck");
  for (const std::string& part : split(text.substr(equals + 1))) {
    const std::string value = trimmed(part);
    if (value.empty())
      throw AxisFault(fmt::format("--set {}: a value is missing", text),
                      "separate the values by single commas");
    if (std::any_of(axis.values.begin(), axis.values.end(),
                    [&](const auto& other) { return is_same_value(other, value); }))
      throw AxisFault(fmt::format("--set {}: the value {} is given twice", text, value),
                      "name each value once");
    axis.values.push_back(value);
  }
  return axis;
}

std::vector<Variation> parse_table(const std::string& text) {
  const auto rows = parse_csv(text);
  const std::vector<std::string>& names = rows.front();
  if (is_empty(names))
    throw AxisFault("the table of parameters has no line with the names of its columns",
                    "name the columns in its first line: seed, FRICTN.fric, ...");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] != "seed" && !is_field(names[i]))
      throw AxisFault(
          fmt::format("the table of parameters has a column '{}'", names[i]),
          "a column is seed or CARD.field; 'blocks cards --set DECK' lists the fields "
          "of a deck");
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i),
                  names[i]) != names.begin() + static_cast<std::ptrdiff_t>(i))
      throw AxisFault(
          fmt::format("the table of parameters has two columns '{}'", names[i]),
          "remove one of them");
  }
  std::vector<Variation> runs;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (is_empty(rows[r]))
      continue;
    if (rows[r].size() != names.size())
      throw AxisFault(
          fmt::format(
              "row {} of the table of parameters has {} values, but there are {} "
              "columns",
              r, rows[r].size(), names.size()),
          "give each run a value of each column");
    Variation run;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (rows[r][i].empty())
        throw AxisFault(fmt::format("row {} of the table of parameters has no value of "
                                    "{}",
                                    r, names[i]),
                        "give each run a value of each column");
      if (names[i] == "seed")
        run.seed = parse_seed(rows[r][i]);
      else
        run.sets.push_back(names[i] + '=' + rows[r][i]);
    }
    runs.push_back(std::move(run));
  }
  if (runs.empty())
    throw AxisFault("the table of parameters has no runs",
                    "write one line per run below the names of the columns");
  if (runs.size() > max_runs)
    refuse_number_of_runs();
  return runs;
}

std::vector<Variation> combine(const std::vector<Variation>& rows,
                               const std::vector<Axis>& axes,
                               const std::vector<std::uint64_t>& seeds) {
  std::vector<Variation> runs = rows.empty() ? std::vector<Variation>(1) : rows;
  std::set<std::string> fields;
  for (const std::string& set : runs.front().sets)
    fields.insert(field_of(set));
  for (const Axis& axis : axes) {
    if (!fields.insert(axis.field).second)
      throw AxisFault(fmt::format("the field {} is given twice", axis.field),
                      "give all its values in one place");
    if (runs.size() * axis.values.size() > max_runs)
      refuse_number_of_runs();
    std::vector<Variation> more;
    for (const Variation& run : runs)
      for (const std::string& value : axis.values) {
        more.push_back(run);
        more.back().sets.push_back(axis.field + '=' + value);
      }
    runs = std::move(more);
  }
  if (!seeds.empty()) {
    if (runs.front().seed)
      throw AxisFault("the seeds are given twice",
                      "give them by --seeds or in the column seed of the table");
    if (runs.size() * seeds.size() > max_runs)
      refuse_number_of_runs();
    std::vector<Variation> more;
    more.reserve(runs.size() * seeds.size());
    for (const Variation& run : runs)
      for (const std::uint64_t seed : seeds) {
        more.push_back(run);
        more.back().seed = seed;
      }
    runs = std::move(more);
  }
  std::vector<const Variation*> sorted;
  sorted.reserve(runs.size());
  for (const Variation& run : runs)
    sorted.push_back(&run);
  const auto key = [](const Variation* run) { return std::tie(run->sets, run->seed); };
  std::sort(sorted.begin(), sorted.end(),
            [&](const Variation* a, const Variation* b) { return key(a) < key(b); });
  const auto twice = std::adjacent_find(
      sorted.begin(), sorted.end(),
      [](const Variation* a, const Variation* b) { return *a == *b; });
  if (twice != sorted.end())
    throw AxisFault(fmt::format("two runs are the same: {}", words_of(**twice)),
                    "remove one of them from the table of parameters");
  return runs;
}

std::string field_of(const std::string& set) { return set.substr(0, set.find('=')); }

std::vector<std::string> axes_of(const Variation& run) {
  std::vector<std::string> axes;
  if (run.seed)
    axes.emplace_back("seed");
  for (const std::string& set : run.sets)
    axes.push_back(field_of(set));
  return axes;
}

std::string value_of(const std::string& set) { return set.substr(set.find('=') + 1); }

std::string words_of(const Variation& run) {
  std::string words = run.seed ? fmt::format("seed {}", *run.seed) : std::string();
  for (const std::string& set : run.sets)
    words += (words.empty() ? "" : ", ") + set;
  return words;
}

}  // namespace blocks::sweep
