// Writes the output files of the commands and keeps older ones.
#pragma once

#include <string>

namespace blocks::apps {

/// Writes the text. An older file of that name is kept as NAME.bak. Throws
/// output::FileError.
void write_text_file(const std::string& path, const std::string& text);

/// True if both names mean the same existing file.
bool same_file(const std::string& a, const std::string& b);

}  // namespace blocks::apps
