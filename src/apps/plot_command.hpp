// `blocks plot`: the command line of the figures and movies.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/options/common_options.hpp"
#include "post/figure/figure.hpp"

namespace blocks::apps {

struct PlotOptions {
  std::string file;
  std::string output;         ///< empty: FILE's name with .png, or _joints.png
  std::vector<double> times;  ///< the nearest frames are used; empty: the last one,
                              ///< of `joints` the first
  int sheet = 0;              ///< number of evenly spaced times; 0: no sheet
  std::optional<double> from, to;      ///< times of a sheet or a movie
  std::optional<int> every;            ///< every Nth frame of a movie; empty: all
  std::optional<double> rate;          ///< pictures of a movie per second; empty: 25
  std::vector<double> zoom;            ///< xmin xmax ymin ymax
  std::vector<double> range;           ///< low high
  std::optional<double> mirror;        ///< x of the symmetry plane [L]
  std::string units;                   ///< "m,kg,s"
  std::vector<std::string> materials;  ///< "1=RED", "2=#8fa88b"
  bool compression_positive = false;
  FigureSize size;
  std::string arrow_scale;  ///< "0.01", "p90"; empty: the largest value
  std::string dblock;       ///< file of DBLOCK cards; empty: none
  bool joints = false;      ///< draw a rose and histograms instead of the blocks
  post::FigureOptions figure;
  const CLI::App* command = nullptr;  ///< tells which options are given
};

void add_plot_options(CLI::App& command, PlotOptions& options);

/// Draws the figure or movie. Returns a code of run::ExitCode.
int plot(PlotOptions options);

}  // namespace blocks::apps
