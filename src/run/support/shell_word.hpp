// Quotes words for the command lines in messages.
#pragma once

#include <string>

namespace blocks::run {

/// Returns text that a POSIX shell reads as one word with exactly these characters. It
/// is in single quotes only if it needs them.
std::string shell_word(const std::string& text);

/// The same for a path, which no program takes for an option.
std::string shell_path(const std::string& path);

}  // namespace blocks::run
