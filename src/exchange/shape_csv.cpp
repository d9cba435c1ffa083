#include <fmt/format.h>

#include <algorithm>

#include "exchange/shape_collector.hpp"

namespace blocks::exchange {
namespace {

constexpr std::string_view csv_blanks = " \t\r";

/// Returns the field without blanks and quotes around it.
WrittenNumber trimmed(std::string_view text, std::size_t begin, std::size_t end) {
  const auto trim = [&](std::string_view what) {
    while (begin < end && what.find(text[begin]) != what.npos)
      ++begin;
    while (begin < end && what.find(text[end - 1]) != what.npos)
      --end;
  };
  trim(csv_blanks);
  if (end - begin >= 2 && text[begin] == '"' && text[end - 1] == '"') {
    ++begin;
    --end;
    trim(csv_blanks);
  }
  return {text.substr(begin, end - begin), begin};
}

class CsvShapes {
 public:
  CsvShapes(std::string_view text, ShapeCollector& shapes)
      : text_(text), shapes_(shapes) {}

  void read(std::size_t begin) {
    bool is_first = true;
    while (begin < text_.size()) {
      const std::size_t next = std::min(text_.find('\n', begin), text_.size());
      const std::string_view line_text = text_.substr(begin, next - begin);
      const std::size_t end = begin + std::min(line_text.find('#'), line_text.size());
      if (const auto line = trimmed(text_, begin, end); !line.text.empty()) {
        if (is_first)
          choose_separator(text_.substr(begin, end - begin));
        const auto fields = split(begin, end);
        if (!is_first)
          row(fields);
        else if (!is_header(fields))
          row(fields);
        else if (!header(fields))
          return;
        is_first = false;
      }
      begin = next + 1;
    }
  }

 private:
  std::string_view text_;
  ShapeCollector& shapes_;
  char separator_ = ',';
  // Names of the coordinates, the field of each, and the number of fields.
  std::vector<std::string> names_ =
      shapes_.wanted() == Shapes::lines
          ? std::vector<std::string>{"x1", "y1", "x2", "y2"}
          : std::vector<std::string>{"x", "y"};
  std::vector<std::size_t> columns_ = {0, 1, 2, 3};
  std::size_t fields_ = names_.size();
  std::optional<std::size_t> joint_;
  bool is_named_ = false;

  void choose_separator(std::string_view line) {
    separator_ = line.find(';') != line.npos   ? ';'
                 : line.find(',') != line.npos ? ','
                                               : ' ';
  }

  std::vector<WrittenNumber> split(std::size_t begin, std::size_t end) const;
  static bool is_header(const std::vector<WrittenNumber>& fields) {
    return std::none_of(fields.begin(), fields.end(), [](const WrittenNumber& field) {
      return geometry::Decimal::parse(field.text).has_value();
    });
  }
  bool header(const std::vector<WrittenNumber>& fields);
  void row(const std::vector<WrittenNumber>& fields);
};

std::vector<WrittenNumber> CsvShapes::split(std::size_t begin, std::size_t end) const {
  std::vector<WrittenNumber> fields;
  const std::string_view line = text_.substr(0, end);
  if (separator_ == ' ') {
    for (begin = line.find_first_not_of(csv_blanks, begin); begin < end;
         begin = line.find_first_not_of(csv_blanks, begin)) {
      const std::size_t stop = std::min(line.find_first_of(csv_blanks, begin), end);
      fields.push_back(trimmed(text_, begin, stop));
      begin = stop;
    }
    return fields;
  }
  for (;;) {
    const std::size_t stop = std::min(line.find(separator_, begin), end);
    fields.push_back(trimmed(text_, begin, stop));
    if (stop == end)
      return fields;
    begin = stop + 1;
  }
}

/// Finds the columns. Returns false if one is missing.
bool CsvShapes::header(const std::vector<WrittenNumber>& fields) {
  std::vector<std::optional<std::size_t>> found(names_.size());
  std::size_t others = 0, first_other = 0;
  bool is_sound = true;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    std::string name(fields[i].text);
    for (char& c : name)
      if (c >= 'A' && c <= 'Z')
        c = static_cast<char>(c - 'A' + 'a');
    const auto at = std::find(names_.begin(), names_.end(), name);
    std::optional<std::size_t>* column =
        at != names_.end() ? &found[static_cast<std::size_t>(at - names_.begin())]
        : name == "joint" && shapes_.wanted() == Shapes::lines ? &joint_
                                                               : nullptr;
    if (!column) {
      if (others++ == 0)
        first_other = fields[i].at;
    } else if (column->has_value()) {
      shapes_.error(fields[i].at, fmt::format("column {} is given twice", name), {},
                    name.size());
      is_sound = false;
    } else {
      *column = i;
    }
  }
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i])
      columns_[i] = *found[i];
    else
      missing.push_back(names_[i]);
  }
  if (!missing.empty()) {
    shapes_.error(fields.front().at,
                  fmt::format("column{} {} {} missing", missing.size() == 1 ? "" : "s",
                              fmt::join(missing, ", "),
                              missing.size() == 1 ? "is" : "are"),
                  fmt::format("give GeoJSON, WKT, or CSV with columns {}{}",
                              fmt::join(names_, ", "),
                              names_.size() == 4 ? " and maybe joint" : ""));
    is_sound = false;
  }
  if (others > 0 && is_sound)
    shapes_.warning(first_other, fmt::format("{} other column{} not read", others,
                                             others == 1 ? " is" : "s are"));
  fields_ = fields.size();
  is_named_ = true;
  return is_sound;
}

void CsvShapes::row(const std::vector<WrittenNumber>& fields) {
  if (fields.size() != fields_) {
    shapes_.error(fields.front().at,
                  fmt::format("expected {} values, found {}", fields_, fields.size()),
                  is_named_
                      ? std::string("give one value for each column of the first line")
                      : fmt::format("give {}, or name the columns in a first line",
                                    fmt::join(names_, ", ")));
    return;
  }
  const auto position = [&](std::size_t first) {
    return Position{fields[columns_[first]], fields[columns_[first + 1]]};
  };
  if (shapes_.wanted() == Shapes::points) {
    shapes_.add_point(position(0));
    return;
  }
  std::optional<int> joint;
  if (joint_ && !fields[*joint_].text.empty())
    joint = shapes_.joint(fields[*joint_]);
  shapes_.add_line({position(0), position(2)}, joint, fields.front().at);
}

}  // namespace

void collect_csv(std::string_view text, std::size_t begin, ShapeCollector& shapes) {
  CsvShapes(text, shapes).read(begin);
}

}  // namespace blocks::exchange
