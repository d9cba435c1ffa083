// Writes the files of the commands, older ones put aside.
#pragma once

#include <string>

namespace blocks::apps {

/// Writes the text; an older file of that name is kept as NAME.bak. Throws
/// output::FileError.
void write_text_file(const std::string& path, const std::string& text);

/// Whether both names mean the same existing file.
bool same_file(const std::string& a, const std::string& b);

}  // namespace blocks::apps
