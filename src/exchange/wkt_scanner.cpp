#include "exchange/wkt_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/decimal.hpp"

namespace blocks::exchange {
namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

constexpr std::string_view delimiters = " \t\r\n(),;";

}  // namespace

std::size_t WktScanner::skip(std::string_view also) {
  while (at_ < text_.size() &&
         (is_blank(text_[at_]) || also.find(text_[at_]) != also.npos))
    ++at_;
  return at_;
}

void WktScanner::fail(const std::string& expected, const std::string& hint) {
  skip();
  const auto end = std::min(text_.find_first_of(delimiters, at_), text_.size());
  std::string_view found = text_.substr(at_, std::max<std::size_t>(end - at_, 1));
  found = found.substr(0, 40);
  throw SyntaxFault{
      at_,
      at_ == text_.size()
          ? fmt::format("expected {}, found the end of the file", expected)
          : fmt::format("expected {}, found '{}'", expected, found),
      std::max<std::size_t>(found.size(), 1), hint};
}

bool WktScanner::take(char c) {
  if (!is_next(c))
    return false;
  ++at_;
  return true;
}

void WktScanner::need(char c, const std::string& expected) {
  if (!take(c))
    fail(expected);
}

std::string WktScanner::word() {
  std::string letters;
  for (skip(); at_ < text_.size() && is_letter(text_[at_]); ++at_)
    letters += static_cast<char>(text_[at_] & ~0x20);  // in capitals
  return letters;
}

bool WktScanner::take_empty() {
  const std::size_t before = at_;
  if (word() == "EMPTY")
    return true;
  at_ = before;
  return false;
}

std::string WktScanner::take_dimensions() {
  const std::size_t before = at_;
  if (std::string tag = word(); tag == "Z" || tag == "M" || tag == "ZM")
    return tag;
  at_ = before;
  return {};
}

WrittenNumber WktScanner::token() {
  skip();
  const auto end = std::min(text_.find_first_of(delimiters, at_), text_.size());
  const WrittenNumber found{text_.substr(at_, end - at_), at_};
  at_ = end;
  return found;
}

WrittenNumber WktScanner::number(const std::string& what, const std::string& hint) {
  const WrittenNumber found = token();
  // WKT does not allow Fortran's exponent letter D, which Decimal accepts.
  if (found.text.find_first_of("dD") != found.text.npos ||
      !geometry::Decimal::parse(found.text)) {
    at_ = found.at;
    fail(what, hint);
  }
  return found;
}

void WktScanner::take_more_numbers() {
  for (int taken = 0; taken < 2 && has_more(); ++taken)
    number("',' or ')'");
}

void WktScanner::take_srid() { at_ = std::min(text_.find(';', at_), text_.size()); }

}  // namespace blocks::exchange
