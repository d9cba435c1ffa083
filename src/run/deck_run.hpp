// Runs a deck that has been built: opens its files, plays its cards, closes the files.
#pragma once

#include <string>
#include <vector>

#include "run/built_deck.hpp"
#include "run/executor/console.hpp"
#include "run/job.hpp"

namespace blocks::run {

/// Makes the steps of the deck and writes its files. warnings: of the check, for the
/// listing and the summary. Throws files::FileError.
ExitCode run_built(Job& job, BuiltDeck built, Console& console,
                   const std::vector<std::string>& warnings);

}  // namespace blocks::run
