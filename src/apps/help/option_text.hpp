// Options in words, for the help pages, the man page and the completion.
#pragma once

#include <CLI/Option.hpp>
#include <string>
#include <vector>

namespace blocks::apps {

/// Returns the word for the value of an option, such as "SECONDS"; empty for a flag.
std::string value_name(const CLI::Option& option);

/// Returns the words that an option accepts; empty if they are not limited.
std::vector<std::string> choices(const CLI::Option& option);

/// Returns the description of an option, its allowed values, its default, and the
/// options that it needs or excludes.
std::string option_meaning(const CLI::Option& option);

/// Breaks text into lines of at most `width` characters. A longer word gets a line of
/// its own.
std::string wrapped(const std::string& text, std::size_t width);

}  // namespace blocks::apps
