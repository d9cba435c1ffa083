// Formats text for man pages, in man(7) format.
#pragma once

#include <string>
#include <string_view>

namespace blocks::text::roff {

/// Returns plain text with the characters that are special in roff escaped.
std::string text(std::string_view words);
std::string bold(std::string_view words);
std::string italic(std::string_view words);

/// Returns the head of the page NAME(SECTION): title line, and NAME with its one-line
/// meaning.
std::string head(std::string_view name, int section, std::string_view version,
                 std::string_view volume, std::string_view meaning);

std::string section(std::string_view title);
std::string subsection(std::string_view title);
std::string paragraph(std::string_view words);
/// Returns a term, which is already in roff, with its meaning in plain text.
std::string item(std::string_view term, std::string_view meaning);
/// Returns the lines verbatim, in a fixed-width font.
std::string example(std::string_view lines);

}  // namespace blocks::text::roff
