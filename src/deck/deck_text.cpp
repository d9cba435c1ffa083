#include "deck/deck_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "deck/free_field.hpp"

namespace blocks::deck {
namespace {

/// Returns the name of the encoding if the text begins like UTF-16 or UTF-32; otherwise
/// empty. Without a byte order mark, some of the first bytes are zero, because a deck
/// begins with an ASCII character.
std::string_view wide_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xff\xfe\0\0"sv) || text.starts_with("\0\0\xfe\xff"sv)) {
    return "UTF-32";
  }
  if (text.substr(0, 3) == "\0\0\0"sv) {
    return "UTF-32BE";
  }
  if (text.size() >= 4 && text[0] != '\0' && text.substr(1, 3) == "\0\0\0"sv) {
    return "UTF-32LE";
  }
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    return "UTF-16";
  }
  if (text.size() < 2 || (text[0] == '\0') == (text[1] == '\0')) {
    return {};
  }
  return text[1] == '\0' ? "UTF-16LE" : "UTF-16BE";
}

/// Returns the sequence number at the end of a line, in columns 73 to 80: letters and
/// digits, the last of them a digit. Without such a number, returns -1.
long sequence_number(const std::string& line) {
  constexpr std::size_t first = 72, end = 80;
  if (line.size() <= first || line.size() > end ||
      !std::isdigit(static_cast<unsigned char>(line.back()))) {
    return -1;
  }
  const std::string tag = line.substr(line.find_first_not_of(' ', first));
  if (!std::all_of(tag.begin(), tag.end(),
                   [](unsigned char c) { return std::isalnum(c) != 0; })) {
    return -1;
  }
  const std::size_t letter = tag.find_last_not_of("0123456789");
  return std::stol(tag.substr(letter + 1));  // npos + 1 is 0
}

/// Whether most lines have sequence numbers that rise, as decks of punched cards do.
/// Lines that were added by hand have none. Long coordinates may end in the same
/// columns, but they do not rise from line to line.
bool has_sequence_numbers(const std::vector<std::string>& lines) {
  constexpr long fewest_lines = 3;
  long rising = 0, falling = 0, others = 0, last = -1;
  for (std::string line : lines) {
    line.erase(line.find_last_not_of(" \t\x1a") + 1);
    if (line.empty()) {
      continue;
    }
    const long number = sequence_number(line);
    ++(number < 0 ? others : number > last ? rising : falling);
    last = std::max(last, number);
  }
  return rising >= fewest_lines && rising > others + 10 * falling;
}

}  // namespace

bool is_deck_text(const std::string& text, Diagnostics& diagnostics) {
  if (const std::string_view kind = wide_encoding(text); !kind.empty()) {
    diagnostics.error({1, 1, 1}, "",
                      fmt::format("the deck is stored as {}", kind.substr(0, 6)),
                      fmt::format("save it as UTF-8, or convert it with iconv -f {} -t "
                                  "UTF-8 OLD.deck >NEW.deck",
                                  kind));
    return false;
  }
  if (const auto where = first_binary_byte(text)) {
    diagnostics.error(*where, "", "not a text file: a control character",
                      "a deck is plain text, ASCII or UTF-8");
    return false;
  }
  constexpr std::size_t longest = 1'000'000;  // bytes
  const std::vector<std::string> lines = source_lines(text);
  if (has_sequence_numbers(lines)) {
    diagnostics.error({1, 73, 8}, "",
                      "the lines have sequence numbers in columns 73 to 80",
                      "a deck is read beyond column 72: cut -c1-72 OLD.deck >NEW.deck");
    return false;
  }
  int number = 0;
  for (const std::string& line : lines) {
    ++number;
    if (line.size() > longest) {
      diagnostics.error(
          {number, 1, 1}, "",
          fmt::format("the line has {} bytes, a line of a deck at most {}", line.size(),
                      longest),
          "coordinates may run over several lines");
      return false;
    }
  }
  return true;
}

bool is_comment_of_fortran(const std::string& word) {
  const std::size_t end = word.find_first_not_of("Cc");
  return word.find_first_of("Cc") == 0 &&
         (end == std::string::npos ||
          std::isalnum(static_cast<unsigned char>(word[end])) == 0);
}

}  // namespace blocks::deck
