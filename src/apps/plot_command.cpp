#include "plot_command.hpp"
#include "fault.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "dblock_plots.hpp"
#include "output/results.hpp"
#include "post/quantity.hpp"
#include "run/run.hpp"

namespace blocks::apps {

void add_plot_options(CLI::App& command, PlotOptions& options) {
  command.add_option("FILE", options.file, "results of a run, NAME.vtkhdf")->required();
  command.add_option("-o,--output", options.output,
                     "figure: .png, .svg or .pdf (default: NAME.png)");
  command.add_option("-t,--time", options.time,
                     "time of the frame (default: the last)");
  command.add_option("--zoom", options.zoom, "xmin xmax ymin ymax")
      ->expected(4)
      ->delimiter(',');
  command.add_option("--width", options.figure.width, "pixels or points")
      ->check(CLI::Range(100, 20000));
  command.add_option("--colour,--color", options.figure.colour,
                     "material, " + post::quantity_names());
  command.add_flag("--numbers", options.figure.numbers, "write the block numbers");
  command.add_flag("--original", options.figure.original,
                   "outline of the first frame underneath");
  command.add_option("--mirror", options.mirror,
                     "draw the other half too, mirrored about this x");
  command
      .add_option("--dblock", options.dblock,
                  "cards of DBLOCK (Appendix E of the report): a series of figures")
      ->excludes("--time");
}

int plot(PlotOptions options) {
  try {
    const post::ResultsReader results(options.file);
    if (!options.zoom.empty())
      options.figure.zoom = Eigen::Vector4d(options.zoom.data());
    if (options.mirror) {
      options.figure.mirror = true;
      options.figure.mirror_x = *options.mirror;
    }
    if (options.output.empty())
      options.output = std::filesystem::path(options.file).stem().string() + ".png";
    if (!options.dblock.empty())
      return plot_dblock(options.dblock, results, options.output, options.figure);
    const long frame = options.time ? results.at(*options.time) : results.frames() - 1;
    post::draw_figure(options.output, results, frame, options.figure);
    return run::done;
  } catch (const std::runtime_error& error) {
    return tell_fault(error);
  }
}

}  // namespace blocks::apps
