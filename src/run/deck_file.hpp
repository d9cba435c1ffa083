// The text of a deck and the names of the files of its run.
#pragma once

#include <string>
#include <string_view>

#include "deck/commands.hpp"

namespace blocks::run {

/// Reads a deck ("-": standard input). Throws output::FileError.
std::string read_deck(const std::string& path);

/// Output name: `given`, else the deck's stem in the present folder ("-": "blocks").
std::string output_name(const std::string& deck, const std::string& given);

/// Folder of the deck, to which file names on its cards are relative.
std::string deck_folder(const std::string& deck);

/// The mesh that a READ9 card reads: named on the card and then beside the deck, or by
/// --tape9 and then from where we are.
std::string mesh_path(const deck::Read9& card, const std::string& folder,
                      const std::string& tape9);

/// A line for each mesh of a deck with a sum of its bytes, by which a restart knows it
/// again; nothing of pipes and of files that are not there.
std::string mesh_sums(const deck::Deck& deck, const std::string& folder,
                      const std::string& tape9);

/// The first line, from 1, in which two texts differ.
long first_difference(std::string_view one, std::string_view other);

/// A file named on a card of a deck in that folder.
std::string beside(const std::string& folder, const std::string& name);

}  // namespace blocks::run
