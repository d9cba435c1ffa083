// `blocks plot`: command line of the figures and movies.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "post/figure.hpp"

namespace blocks::apps {

struct PlotOptions {
  std::string file;
  std::string output;                  ///< empty: FILE's stem with .png
  std::vector<double> times;           ///< the frames nearest to them; else the last
  int sheet = 0;                       ///< so many times, evenly spread
  std::optional<double> from, to;      ///< times of a sheet or a movie
  std::optional<int> every;            ///< frames of a movie; all
  std::optional<double> rate;          ///< pictures of a movie in a second; 25
  std::vector<double> zoom;            ///< xmin xmax ymin ymax
  std::vector<double> range;           ///< low high
  std::optional<double> mirror;        ///< x of the plane
  std::string units;                   ///< "m,kg,s"
  std::vector<std::string> materials;  ///< "1=RED", "2=#8fa88b"
  std::string dblock;                  ///< file with cards of DBLOCK; empty: none
  post::FigureOptions figure;
};

void add_plot_options(CLI::App& command, PlotOptions& options);

/// Draws the figure or movie. Returns an exit code of run::ExitCode.
int plot(PlotOptions options);

}  // namespace blocks::apps
