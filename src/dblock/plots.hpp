// Draws the plots that DBLOCK cards describe.
#pragma once

#include <string>

#include "post/figure/figure.hpp"

namespace blocks::dblock {

/// Draws NAME_01.png, ... for the output NAME.png (.svg, .pdf), one for each time and
/// without repeated frames. It draws NAME.png itself if there is only one. PRINT writes
/// to standard output. A movie has `rate` pictures per second. Errors of the cards are
/// printed. Returns a code of run::ExitCode.
int plot(const std::string& cards_file, const post::ResultsReader& results,
         const std::string& output, double rate, post::FigureOptions figure);

}  // namespace blocks::dblock
