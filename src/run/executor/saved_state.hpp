// The checkpoints of SAVE cards and their names (docs/rest.md#stages).
#pragma once

#include <string>
#include <string_view>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "output/results/results.hpp"

namespace blocks::run {

inline constexpr std::string_view checkpoint_ending = ".ckpt.h5";

/// Returns the file that a SAVE card writes: NAME.ckpt.h5 in the folder of the output
/// name. The card may give the ending too.
std::string saved_path(const std::string& output_name, const std::string& name);

/// Returns the checkpoint that a RESTART card names: a file, or a name of a SAVE card.
/// The file is looked up in `folder`, and then beside the output name if that is not
/// empty. Returns the name in `folder` if there is no such file.
std::string checkpoint_named(const std::string& folder, const std::string& name,
                             const std::string& output_name);

/// Reports SAVE cards whose files would be those of another SAVE card, of the run, or
/// of the RESTART card, and names with a folder.
void check_saves(const deck::Deck& deck, const std::string& output_name,
                 const std::string& restarts_from, deck::Diagnostics& diagnostics);

/// Renames an existing file to .bak, .bak2, ..., unless it is a checkpoint of the same
/// deck, text and options. Returns a warning if it was renamed. Throws FileError if the
/// path cannot be replaced.
std::string put_aside_unless_own(const std::string& path,
                                 const output::RunIdentity& identity);

}  // namespace blocks::run
