// `blocks plot`: command line of the figures.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "post/figure.hpp"

namespace blocks::apps {

struct PlotOptions {
  std::string file;
  std::string output;            ///< empty: FILE's stem with .png
  std::optional<double> time;    ///< the frame nearest to it; else the last
  std::vector<double> zoom;      ///< xmin xmax ymin ymax
  std::optional<double> mirror;  ///< x of the plane
  std::string dblock;            ///< file with cards of DBLOCK; empty: none
  post::FigureOptions figure;
};

void add_plot_options(CLI::App& command, PlotOptions& options);

/// Draws the figure. Returns an exit code of run::ExitCode.
int plot(PlotOptions options);

}  // namespace blocks::apps
