// The plots that cards of DBLOCK ask for.
#pragma once

#include <string>

#include "post/figure.hpp"

namespace blocks::apps {

/// Draws NAME_01.png, ... for the output NAME.png (.svg, .pdf), one for each time, each
/// frame once; NAME.png itself when there is only one. PRINT goes to standard output.
/// A movie takes `rate` pictures a second. Returns an exit code of run::ExitCode:
/// faults of the cards are printed.
int plot_dblock(const std::string& cards_file, const post::ResultsReader& results,
                const std::string& output, double rate, post::FigureOptions figure);

}  // namespace blocks::apps
