#include "exchange/wkt_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "exchange/ring.hpp"
#include "geometry/decimal.hpp"

namespace blocks::exchange {
namespace {

struct SyntaxFault {
  std::size_t at;
  std::string message;
  std::size_t length;
};

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'a' && c <= 'z')
      c = static_cast<char>(c - 'a' + 'A');
  return text;
}

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

constexpr int deepest = 32;  // levels of nested collections

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  OutlineFile read() {
    try {
      for (skip(";"); at_ < text_.size(); skip(";"))
        geometry(0);
    } catch (const SyntaxFault& fault) {
      rings_.error(fault.at, fault.message, {}, fault.length);
    }
    return rings_.finish("WKT");
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  RingReader rings_;

  /// Skips blanks and the characters of `also`.
  void skip(std::string_view also = "") {
    while (at_ < text_.size() &&
           (is_blank(text_[at_]) || also.find(text_[at_]) != also.npos))
      ++at_;
  }

  [[noreturn]] void fail(const std::string& expected) {
    skip();
    const auto end = std::min(text_.find_first_of(" \t\r\n(),;", at_), text_.size());
    std::string_view found = text_.substr(at_, std::max<std::size_t>(end - at_, 1));
    found = found.substr(0, 40);
    throw SyntaxFault{
        at_,
        at_ == text_.size()
            ? fmt::format("expected {}, found the end of the file", expected)
            : fmt::format("expected {}, found '{}'", expected, found),
        std::max<std::size_t>(found.size(), 1)};
  }

  bool take(char c) {
    skip();
    if (at_ == text_.size() || text_[at_] != c)
      return false;
    ++at_;
    return true;
  }

  void need(char c, const std::string& expected) {
    if (!take(c))
      fail(expected);
  }

  /// Returns the next word in capitals; empty if there is none.
  std::string word() {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_letter(text_[at_]))
      ++at_;
    return upper(text_.substr(begin, at_ - begin));
  }

  WrittenNumber number(const std::string& what) {
    skip();
    const auto end = std::min(text_.find_first_of(" \t\r\n(),;", at_), text_.size());
    const WrittenNumber found{text_.substr(at_, end - at_), at_};
    // WKT does not allow Fortran's exponent letter D, which Decimal accepts.
    if (found.text.find_first_of("dD") != found.text.npos ||
        !geometry::Decimal::parse(found.text))
      fail(what);
    at_ = end;
    return found;
  }

  bool empty() {
    const std::size_t before = at_;
    if (word() == "EMPTY")
      return true;
    at_ = before;
    return false;
  }

  /// Performs the action for each item of "( item, item, ... )".
  template <class Action> void list(Action action) {
    need('(', "'('");
    do
      action();
    while (take(','));
    need(')', "',' or ')'");
  }

  void geometry(int depth);
  void polygon(std::size_t begin);
  std::vector<Position> ring();
};

void Reader::geometry(int depth) {
  skip();
  const std::size_t begin = at_;
  const std::string kind = word();
  if (kind == "SRID") {
    at_ = std::min(text_.find(';', at_), text_.size());
    rings_.warning(begin, "SRID is ignored: coordinates are taken as lengths");
    return;
  }
  std::size_t after = at_;
  if (const std::string tag = word(); tag == "Z" || tag == "M" || tag == "ZM")
    after = at_;  // reported with the first position that has a third number
  at_ = after;
  if (kind != "POLYGON" && kind != "MULTIPOLYGON" && kind != "GEOMETRYCOLLECTION") {
    at_ = begin;
    fail("POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION");
  }
  if (empty()) {
    rings_.warning(begin, kind + " EMPTY is skipped");
  } else if (kind == "POLYGON") {
    polygon(begin);
  } else if (kind == "MULTIPOLYGON") {
    list([&] {
      skip();
      const std::size_t one = at_;
      if (empty())
        rings_.warning(one, "POLYGON EMPTY is skipped");
      else
        polygon(one);
    });
  } else if (depth == deepest) {
    throw SyntaxFault{begin, fmt::format("nested deeper than {}", deepest), 1};
  } else {
    list([&] { geometry(depth + 1); });
  }
}

void Reader::polygon(std::size_t begin) {
  std::vector<Position> outer;
  std::size_t rings = 0;
  list([&] {
    auto positions = ring();
    if (rings++ == 0)
      outer = std::move(positions);
  });
  if (rings > 1)
    rings_.refuse_holes(rings - 1, begin);
  else
    rings_.add(outer, 0, false, begin);
}

std::vector<Position> Reader::ring() {
  std::vector<Position> positions;
  list([&] {
    const WrittenNumber x = number("a number, x"), y = number("a number, y");
    positions.push_back({x, y});
    skip();
    if (at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')') {
      rings_.saw_height(x.at);
      number("',' or ')'");
      skip();
      if (at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')')
        number("',' or ')'");
    }
  });
  return positions;
}

}  // namespace

OutlineFile read_wkt(std::string_view text) { return Reader(text).read(); }

bool looks_like_wkt(std::string_view text) {
  const auto begin =
      std::find_if_not(text.begin(), text.end(), [](char c) { return is_blank(c); });
  const auto end = std::find_if_not(begin, text.end(), is_letter);
  const std::string first = upper(text.substr(begin - text.begin(), end - begin));
  constexpr std::array words{
      "POLYGON",    "MULTIPOLYGON", "GEOMETRYCOLLECTION", "POINT",
      "LINESTRING", "MULTIPOINT",   "MULTILINESTRING",    "POLYHEDRALSURFACE",
      "TRIANGLE",   "TIN",          "CURVEPOLYGON",       "MULTISURFACE",
      "SRID"};
  return std::find(words.begin(), words.end(), first) != words.end();
}

}  // namespace blocks::exchange
