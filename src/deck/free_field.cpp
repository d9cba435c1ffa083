#include "deck/free_field.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

#include "deck/selector.hpp"
#include "text/capitals.hpp"
#include "text/suggest.hpp"

namespace blocks::deck {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Tests for a blank: also tab, form feed, the Ctrl-Z that ended files under CP/M and
/// DOS, and the no-break space of copied text.
bool is_blank(const std::string& c) {
  return c == " " || c == "\t" || c == "\f" || c == "\v" || c == "\x1a" ||
         c == "\xc2\xa0";
}

bool is_not_finite_word(std::string_view text) {
  std::string word = text::capitals(text);
  if (!word.empty() && (word[0] == '+' || word[0] == '-')) {
    word.erase(0, 1);
  }
  return word == "NAN" || word == "INF" || word == "INFINITY";
}

/// Returns the number of bytes of the UTF-8 character at the front, or 0 if there is
/// none.
std::size_t utf8_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  std::size_t length = 0;
  if (lead < 0x80) {
    return 1;
  }
  if (lead >= 0xc2 && lead < 0xe0) {
    length = 2;
  } else if (lead >= 0xe0 && lead < 0xf0) {
    length = 3;
  } else if (lead >= 0xf0 && lead < 0xf5) {
    length = 4;
  }
  if (length == 0 || text.size() < length) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) {
      return 0;
    }
  }
  return length;
}

bool is_comment(const std::string& c) { return c == "$" || c == "!"; }

bool ends_field(const std::string& c) {
  return c == "," || is_blank(c) || is_comment(c);
}

/// Reads the field that begins with a quote at chars[at], and moves `at` behind it.
Field take_quoted(const std::vector<std::string>& chars, std::size_t& at) {
  const auto begin = chars.begin() + static_cast<long>(at);
  const auto close = std::find(begin + 1, chars.end(), *begin);
  Field field{.text = {}, .where = {}, .quoted = true};
  if (close != chars.end() && (close + 1 == chars.end() || ends_field(close[1]))) {
    field.text = std::accumulate(begin + 1, close, std::string());
    at += static_cast<std::size_t>(close - begin) + 1;
    return field;
  }
  field.fault = close == chars.end() ? QuoteFault::not_closed : QuoteFault::text_after;
  field.text = std::accumulate(begin, chars.end(), std::string());
  at = chars.size();
  return field;
}

/// Returns where the brackets that open at chars[at] end: just after the closing one,
/// or `at` if they are not closed before a comment or the end of the line.
std::size_t end_of_brackets(const std::vector<std::string>& chars, std::size_t at) {
  for (std::size_t i = at + 1; i < chars.size() && !is_comment(chars[i]); ++i) {
    if (chars[i] == ")") {
      return i + 1;
    }
  }
  return at;
}

/// Reads the field without quotes that begins at chars[at], and moves `at` behind it.
/// Commas and blanks between brackets belong to it. A selector whose bracket is not
/// closed has the rest of the line.
std::string take_plain(const std::vector<std::string>& chars, std::size_t& at) {
  std::string text;
  while (at < chars.size() && !ends_field(chars[at])) {
    std::size_t end = at + 1;
    if (chars[at] == "(" && ends_in_selector_name(text)) {
      const std::size_t closed = end_of_brackets(chars, at);
      end = closed > at ? closed : chars.size();
    }
    while (at < end) {
      text += chars[at++];
    }
  }
  return text;
}

}  // namespace

bool Line::is_data() const {
  const Field& first = fields.front();
  if (first.blank) {
    return true;
  }
  if (first.quoted) {
    return false;
  }
  const char c = first.text.front();
  if (!is_letter(c)) {
    return true;
  }
  if (const std::size_t bracket = first.text.find('(');
      bracket != std::string::npos &&
      ends_in_selector_name(first.text.substr(0, bracket))) {
    return true;
  }
  // "O.5", with a mistyped zero, is a value as well: no card has a point in its name.
  return is_not_finite_word(first.text) || first.text.find('.') != std::string::npos;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) {
      return false;
    }
    text.remove_prefix(length);
  }
  return true;
}

std::vector<std::string> source_lines(std::string_view text) {
  if (text.substr(0, 3) == "\xef\xbb\xbf") {
    text.remove_prefix(3);
  }
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    lines.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
    if (end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n') {
      ++begin;
    }
  }
  return lines;
}

std::vector<std::string> characters(std::string_view line) {
  std::vector<std::string> out;
  out.reserve(line.size());
  while (!line.empty()) {
    const std::size_t length = utf8_length(line);
    if (length == 0) {
      out.emplace_back("?");
      line.remove_prefix(1);
    } else {
      out.emplace_back(line.substr(0, length));
      line.remove_prefix(length);
    }
  }
  return out;
}

Line split_fields(std::string_view text, int number) {
  const std::vector<std::string> chars = characters(text);
  Line line;
  std::size_t at = 0;
  std::size_t last = 0;  // just after the last field
  bool after_field = false;
  const auto column = [](std::size_t i) { return static_cast<int>(i) + 1; };
  while (at < chars.size()) {
    const std::string& c = chars[at];
    if (is_blank(c)) {
      ++at;
    } else if (is_comment(c)) {
      break;
    } else if (c == ",") {
      if (!after_field) {
        line.fields.push_back({"", {number, column(at), 1}, true, false});
      }
      after_field = false;
      last = ++at;
    } else {
      const std::size_t begin = at;
      Field field;
      if (c == "'" || c == "\"") {
        field = take_quoted(chars, at);
      } else {
        field.text = take_plain(chars, at);
      }
      last = at;
      after_field = true;
      field.blank = field.text.empty();
      field.where = {number, column(begin), static_cast<int>(at - begin)};
      line.fields.push_back(std::move(field));
    }
  }
  line.end = {number, column(last), 1};
  line.comma = !line.fields.empty() && !after_field;
  return line;
}

std::vector<Line> split_deck(std::string_view text) {
  const std::vector<std::string> source = source_lines(text);
  std::vector<Line> lines;
  for (std::size_t i = 0; i < source.size(); ++i) {
    Line line = split_fields(source[i], static_cast<int>(i) + 1);
    if (line.fields.empty()) {
      continue;
    }
    // A misspelt START at the head of the deck is also followed by its title.
    const std::string word = text::capitals(line.fields.front().text);
    if (word == "START" ||
        (lines.empty() && !line.is_data() && !text::suggest(word, {"START"}).empty())) {
      line.title_where = line.end;
      if (i + 1 < source.size()) {
        std::string title = source[++i];
        title.erase(title.find_last_not_of(" \t\x1a") + 1);
        line.title_where = {static_cast<int>(i) + 1, 1,
                            static_cast<int>(characters(title).size())};
        line.title = std::move(title);
      }
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Number read_number(std::string_view text) {
  if (is_not_finite_word(text)) {
    return {{}, NumberFault::not_finite};
  }
  const Number bad{{}, NumberFault::not_a_number};
  std::size_t at = 0;
  const auto digits = [&] {
    std::string out;
    while (at < text.size() && is_digit(text[at])) {
      out += text[at++];
    }
    return out;
  };
  const auto sign = [&]() -> std::string {
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) {
      return text[at++] == '-' ? "-" : "";
    }
    return "";
  };
  std::string plain = sign();
  bool small = false;  // the exponent is negative
  const std::string whole = digits();
  std::string fraction;
  if (at < text.size() && text[at] == '.') {
    ++at;
    fraction = digits();
  }
  if (whole.empty() && fraction.empty()) {
    return bad;
  }
  plain += whole.empty() ? "0" : whole;
  if (!fraction.empty()) {
    plain += "." + fraction;
  }
  if (at < text.size()) {
    // Fortran's list-directed input reads 1.5+3 as 1.5E+3: a sign replaces the letter.
    const char letter = text[at];
    if (letter == 'e' || letter == 'E' || letter == 'd' || letter == 'D') {
      ++at;
    } else if (letter != '+' && letter != '-') {
      return bad;
    }
    const std::string minus = sign();
    std::string power = digits();
    if (power.empty() || at < text.size()) {
      return bad;
    }
    power.erase(0, std::min(power.find_first_not_of('0'), power.size() - 1));
    // An exponent of six digits can only be a mistake, and exact numbers of that size
    // would slow down the geometry.
    const bool zero = (whole + fraction).find_first_not_of('0') == std::string::npos;
    if (power.size() > 5 && !zero) {
      return {{}, minus.empty() ? NumberFault::not_finite : NumberFault::too_small};
    }
    plain += "e" + minus + (zero ? "0" : power);
    small = !minus.empty();
  }
  const auto value = geometry::Decimal::parse(plain);
  if (!value) {
    return {{}, small ? NumberFault::too_small : NumberFault::not_finite};
  }
  return {*value, NumberFault::none};
}

std::optional<SourceLocation> first_binary_byte(std::string_view text) {
  SourceLocation where{1, 1, 1};
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n') {
      ++where.line;
      where.column = 0;
    } else if ((byte < 0x20 && c != '\t' && c != '\r' && c != '\f' && c != '\v' &&
                c != '\x1a') ||
               byte == 0x7f) {
      return where;
    }
    ++where.column;
  }
  return std::nullopt;
}

}  // namespace blocks::deck
