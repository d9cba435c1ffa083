// Text for man pages, the language of man(7).
#pragma once

#include <string>
#include <string_view>

namespace blocks::deck::roff {

/// Plain words, with what the language would take for its own escaped.
std::string text(std::string_view words);
std::string bold(std::string_view words);
std::string italic(std::string_view words);

/// The head of the page NAME(SECTION): title line, NAME with its one-line meaning.
std::string head(std::string_view name, int section, std::string_view version,
                 std::string_view volume, std::string_view meaning);

std::string section(std::string_view title);
std::string subsection(std::string_view title);
std::string paragraph(std::string_view words);
/// A term, already in roff, and what it means, in words.
std::string item(std::string_view term, std::string_view meaning);
/// Lines as they stand, in a fixed font.
std::string example(std::string_view lines);

}  // namespace blocks::deck::roff
