#include "deck/deck_text.hpp"

#include <fmt/format.h>

#include <string_view>

#include "deck/free_field.hpp"

namespace blocks::deck {
namespace {

/// Returns UTF-16, UTF-16LE or UTF-16BE if the text begins like one of them; otherwise
/// empty. Without a byte order mark, one of the first two bytes is zero, because a deck
/// begins with an ASCII character.
std::string_view utf16_kind(std::string_view text) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    return "UTF-16";
  }
  if (text.size() < 2 || (text[0] == '\0') == (text[1] == '\0')) {
    return {};
  }
  return text[1] == '\0' ? "UTF-16LE" : "UTF-16BE";
}

}  // namespace

bool is_deck_text(const std::string& text, Diagnostics& diagnostics) {
  if (const std::string_view kind = utf16_kind(text); !kind.empty()) {
    diagnostics.error({1, 1, 1}, "", "the deck is stored as UTF-16",
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
  int number = 0;
  for (const std::string& line : source_lines(text)) {
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

}  // namespace blocks::deck
