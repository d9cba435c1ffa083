#include "exchange/dxf_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "exchange/dxf_kinds.hpp"

namespace blocks::exchange {
namespace {

constexpr std::size_t longest_line = 1000;  // dxflib reads lines of up to 1,023
constexpr std::size_t max_entities = 10'000'000;

struct Group {
  int code = 0;
  std::string_view value;
  std::size_t begin = 0;  ///< of the line of the code
  std::size_t at = 0;     ///< of the value
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  return first == text.npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// Takes one group after the other.
class GroupScanner {
 public:
  explicit GroupScanner(std::string_view text) : text_(text) {
    if (text.starts_with("\xEF\xBB\xBF"))
      at_ = 3;
  }

  /// Returns the next group; nothing at the end, or after a fault.
  std::optional<Group> next() {
    Group group;
    group.begin = at_;
    if (at_ >= text_.size() || trimmed(text_.substr(at_)).empty())
      return {};
    const std::string_view code = line();
    if (at_ > text_.size())
      return fail(group.begin, "the drawing ends after a group code without its value",
                  "the file is cut off: write it again");
    group.at = at_;
    group.value = line();
    const char* end = code.data() + code.size();
    if (std::from_chars(code.data(), end, group.code).ptr != end || code.empty())
      return fail(
          group.begin,
          fmt::format("expected a group code, found '{}'", code.substr(0, 40)),
          "a drawing has pairs of lines: a whole number, then its value; a line "
          "before this one is missing or too many");
    if (code.size() > longest_line || group.value.size() > longest_line)
      return fail(group.at,
                  fmt::format("a line of more than {} characters", longest_line),
                  "lines of a drawing are shorter: the file is damaged");
    if (group.value.find('\0') != group.value.npos)
      return fail(group.at, "a character with code 0", "the file is damaged");
    return group;
  }

  std::optional<Message> fault;

 private:
  std::string_view text_;
  std::size_t at_ = 0;

  /// Takes a line; afterwards at_ is beyond the end if no line follows.
  std::string_view line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view found = text_.substr(at_, end - at_);
    at_ = end + 1;
    return trimmed(found);
  }

  std::nullopt_t fail(std::size_t at, std::string message, std::string hint) {
    fault = Message{true, at, std::move(message), std::move(hint)};
    at_ = text_.size();
    return std::nullopt;
  }
};

bool is_finite_number(std::string_view text) {
  if (text.starts_with('+'))
    text.remove_prefix(1);
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() &&
         std::isfinite(value);
}

bool is_real(int code) {
  return (code >= 10 && code <= 59) || (code >= 210 && code <= 239);
}

/// A number of things that an entity states, and the group that begins each of them.
struct Count {
  std::string_view kind;
  int stated, of;
  const char* what;
};
constexpr std::array counts{
    Count{"LWPOLYLINE", 90, 10, "vertices"}, Count{"SPLINE", 72, 40, "knots"},
    Count{"SPLINE", 73, 10, "control points"}, Count{"SPLINE", 74, 11, "fit points"}};

class EntityFinder {
 public:
  explicit EntityFinder(std::string_view text) : text_(text), scan_(text) {}

  DxfGroups find() {
    while (const auto group = scan_.next()) {
      if (group->code == 0)
        begin(*group);
      else
        add(*group);
      before_ = *group;
    }
    close(text_.size());
    if (scan_.fault)
      found_.messages.push_back(*scan_.fault);
    else if (before_.code != 0 || before_.value != "EOF")
      error(text_.size(), "the drawing does not end with EOF",
            "the file is cut off: write it again");
    else if (!has_entities_)
      found_.messages.push_back(
          {true, nowhere, "the drawing has no section ENTITIES",
           "write the drawing again, as an ASCII DXF of R12 or later", 0});
    return std::move(found_);
  }

 private:
  std::string_view text_;
  GroupScanner scan_;
  DxfGroups found_;
  Group before_;
  std::string_view section_;
  bool has_entities_ = false, is_open_ = false, is_read_ = false;
  bool is_full_ = false;
  std::size_t begin_ = 0;
  std::map<int, long> stated_, met_;  // of the open entity, by group code

  void error(std::size_t at, std::string message, std::string hint,
             std::size_t length = 1) {
    found_.messages.push_back({true, at, std::move(message), std::move(hint), length});
  }

  /// A group 0 begins an entity, a vertex of the open polyline, or a section.
  void begin(const Group& group) {
    if (is_open_ && found_.entities.back().kind == "POLYLINE" &&
        (group.value == "VERTEX" || group.value == "SEQEND"))
      return;
    if (group.value.find_first_not_of("0123456789+-.eE") == group.value.npos)
      error(group.at,
            fmt::format("expected the name of an entity, found '{}'",
                        group.value.substr(0, 40)),
            "a drawing has pairs of lines: a whole number, then its value; a line "
            "before this one is missing or too many");
    close(group.begin + (group.at - group.begin) + group.value.size());
    if (group.value == "SECTION" || group.value == "ENDSEC")
      section_ = {};
    else if (section_ == "ENTITIES" && group.value != "EOF")
      open(group);
  }

  void open(const Group& group) {
    if (found_.entities.size() == max_entities) {
      if (!is_full_)
        error(group.at, fmt::format("more than {} entities", max_entities),
              "divide the drawing into parts");
      is_full_ = true;
      return;
    }
    found_.entities.push_back({group.value, group.at, {}, false});
    is_open_ = true;
    is_read_ = is_dxf_line(group.value);
    begin_ = group.begin;
    if (is_read_) {
      stated_.clear();
      met_.clear();
    }
  }

  /// Ends the open entity. end: after the kind of the next one.
  void close(std::size_t end) {
    if (!is_open_)
      return;
    DxfEntity& entity = found_.entities.back();
    entity.groups = text_.substr(begin_, std::min(end, text_.size()) - begin_);
    is_open_ = false;
    for (const Count& count : counts)
      if (count.kind == entity.kind && stated_[count.stated] != met_[count.of])
        error(entity.at,
              fmt::format("{} states {} {}, but has {}", entity.kind,
                          stated_[count.stated], count.what, met_[count.of]),
              "the file is damaged or was edited: write it again", entity.kind.size());
  }

  void add(const Group& group) {
    if (before_.code == 0 && before_.value == "SECTION" && group.code == 2) {
      section_ = group.value;
      has_entities_ = has_entities_ || section_ == "ENTITIES";
    }
    if (section_ == "HEADER" && before_.code == 9 && before_.value == "$INSUNITS")
      std::from_chars(group.value.data(), group.value.data() + group.value.size(),
                      found_.unit);
    if (!is_open_)
      return;
    if (group.code == 67)
      found_.entities.back().is_on_paper = group.value == "1";
    if (!is_read_)
      return;
    if (is_real(group.code) && !is_finite_number(group.value))
      error(group.at,
            fmt::format("expected a number, found '{}'", group.value.substr(0, 40)),
            "numbers are finite, with a decimal point, as 1.5 or 1.5e-3",
            std::max<std::size_t>(group.value.size(), 1));
    ++met_[group.code];
    if (group.code >= 70 && group.code <= 99) {
      long value = 0;
      std::from_chars(group.value.data(), group.value.data() + group.value.size(),
                      value);
      stated_[group.code] = value;
    }
  }
};

}  // namespace

bool looks_like_dxf(std::string_view text) {
  if (text.starts_with("AutoCAD Binary DXF"))
    return true;
  GroupScanner scan(text);
  auto group = scan.next();
  while (group && group->code == 999)  // a comment
    group = scan.next();
  return group && group->code == 0 &&
         (group->value == "SECTION" || group->value == "EOF");
}

DxfGroups find_dxf_entities(std::string_view text) {
  if (text.starts_with("AutoCAD Binary DXF"))
    return {{}, 0, {{true, 0, "a binary drawing", "save it as an ASCII DXF"}}};
  return EntityFinder(text).find();
}

}  // namespace blocks::exchange
