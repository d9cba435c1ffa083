// The plots that cards of DBLOCK ask for.
#pragma once

#include <string>

#include "post/figure.hpp"

namespace blocks::apps {

/// Draws NAME_01.png, ... for the output NAME.png (.svg, .pdf), one for each time, each
/// frame once; NAME.png itself when there is only one. PRINT goes to standard output.
/// Returns an exit code of run::ExitCode: faults of the cards are printed.
int plot_dblock(const std::string& cards_file, const post::ResultsReader& results,
                const std::string& output, post::FigureOptions figure);

}  // namespace blocks::apps
