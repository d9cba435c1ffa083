// Reads the text of a deck and determines the names of the files of its run.
#pragma once

#include <string>
#include <string_view>

#include "deck/commands.hpp"

namespace blocks::run {

/// Reads a deck ("-": standard input). Throws files::FileError, also if it is a
/// folder, a device or a FIFO. The exception is a stream that is already open:
/// /dev/stdin, or one in /dev/fd.
std::string read_deck(const std::string& path);

/// The output name: `given`, or the deck's stem in the current directory ("-":
/// "blocks"). If `given` ends with '/', it is a folder, and the stem is appended.
std::string output_name(const std::string& deck, const std::string& given);

/// The folder of the deck; file names on its cards are relative to it.
std::string deck_folder(const std::string& deck);

/// The path of the mesh that a READ9 card reads. A name on the card is relative to the
/// deck's folder, the name given by --tape9 to the current directory.
std::string mesh_path(const deck::Read9& card, const std::string& folder,
                      const std::string& tape9);

/// Returns one line per file that a READ9, TRACES or VORONOI card reads, with a hash of
/// its bytes, so that a restart detects changed files. Pipes and missing files are
/// omitted.
std::string file_sums(const deck::Deck& deck, const std::string& folder,
                      const std::string& tape9);

/// Whether the text begins with a line of file_sums.
bool holds_file_sums(std::string_view text);

/// The first line in which two texts differ, counted from 1.
long first_difference(std::string_view one, std::string_view other);

/// The path of a file named on a card of a deck in `folder`.
std::string beside(const std::string& folder, const std::string& name);

}  // namespace blocks::run
