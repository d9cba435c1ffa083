// Finds the word of a command line that names no command and no option, and suggests
// the right one.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace blocks::apps {

/// Returns the message about the first word that is no command, or that begins with
/// "--" and is no option of its command. Returns an empty text if there is no such
/// word.
std::string tell_wrong_word(const CLI::App& app, int argc, const char* const* argv);

}  // namespace blocks::apps
