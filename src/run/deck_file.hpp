// The text of a deck and the names of the files of its run.
#pragma once

#include <string>

namespace blocks::run {

/// Reads a deck ("-": standard input). Throws output::FileError.
std::string read_deck(const std::string& path);

/// Output name: `given`, else the deck's stem in the present folder ("-": "blocks").
std::string output_name(const std::string& deck, const std::string& given);

/// Folder of the deck, to which file names on its cards are relative.
std::string deck_folder(const std::string& deck);

/// A file named on a card of a deck in that folder.
std::string beside(const std::string& folder, const std::string& name);

}  // namespace blocks::run
