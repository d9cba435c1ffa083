#include "plot_command.hpp"
#include "fault.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "apps/options/quoted_list.hpp"
#include "dblock/cards.hpp"
#include "dblock/plots.hpp"
#include "deck/free_field.hpp"
#include "files/check_outputs.hpp"
#include "plot_frames.hpp"
#include "post/chart/joints_figure.hpp"
#include "post/figure/figure_scales.hpp"
#include "post/figure/movie.hpp"
#include "post/read/frame_quantity.hpp"
#include "post/read/material_list.hpp"
#include "quantities/statistic.hpp"
#include "run/run.hpp"
#include "text/capitals.hpp"
#include "text/counted.hpp"

namespace blocks::apps {
namespace {

/// Prints the times of the frames that differ from those asked for. A figure in print
/// has only its own times.
void print_other_times(const post::ResultsReader& results,
                       const std::vector<long>& frames,
                       const post::FigureOptions& figure) {
  for (std::size_t i = 0; i < figure.requested_times.size(); ++i) {
    const double time = results.times()[static_cast<std::size_t>(frames[i])];
    const std::string text =
        post::time_text(time, figure.requested_times[i], figure.units);
    if (text != post::time_text(time, std::nullopt, figure.units))
      fmt::print("{}\n", text);
  }
}

/// Checks the extension of the output before any file is read.
void check_ending(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  for (const char* known : {".png", ".svg", ".pdf", ".mp4", ".gif"})
    if (ending == known)
      return;
  throw std::runtime_error("the output's name must end in .png, .svg or .pdf (a "
                           "figure), .mp4 or .gif (a movie), found '" +
                           path + "'");
}

/// Throws std::runtime_error if --joints is given with an option that it does not use.
void check_options_of_joints(const PlotOptions& options) {
  static const std::set<std::string> usable = {"joints", "output", "time", "title",
                                               "units",  "width",  "size"};
  for (const CLI::Option* other : options.command->get_options())
    if (other->count() > 0 && !other->get_positional() &&
        !usable.contains(other->get_lnames().front()))
      throw std::runtime_error(fmt::format(
          "--joints and --{} exclude each other\n  hint: --joints uses --output, "
          "--time, --title, --units, --width and --size",
          other->get_lnames().front()));
  if (post::is_movie(options.output))
    throw std::runtime_error("--joints is for a figure: -o NAME.png, .svg or .pdf");
  if (options.times.size() > 1)
    throw std::runtime_error("--joints draws one time; give a single time with -t");
}

/// Throws std::runtime_error if an option would have no effect.
void check_combinations(const PlotOptions& options) {
  const auto refuse = [](bool given, const std::string& words) {
    if (given)
      throw std::runtime_error(words);
  };
  const bool movie = post::is_movie(options.output);
  const bool sheet = !movie && (options.sheet > 0 || options.times.size() > 1);
  const std::string a_movie = " is for a movie: -o NAME.mp4 or NAME.gif";
  refuse(!options.size.size.empty() && movie,
         "--size is for a figure; choose the width of a movie with --width");
  refuse(options.every && !movie, "--every" + a_movie);
  refuse(options.rate && !movie, "--rate" + a_movie);
  refuse(options.figure.columns > 0 && !sheet,
         "--columns is for a sheet: --sheet 4 or -t 0,1,2");
  refuse((options.from || options.to) && options.sheet == 0 &&
             (!movie || !options.times.empty()),
         "--from and --to are for --sheet or a movie; give a single time with -t");
  refuse(options.sheet > 0 && movie,
         "--sheet is for a figure; limit a movie with --from, --to and --every");
  refuse(options.mirror && !std::isfinite(*options.mirror),
         "--mirror needs the x of the symmetry plane of a half model");
  const bool by_material = !options.figure.shows_values();
  for (const double end : options.range)
    refuse(!std::isfinite(end), "--range needs two finite numbers, low,high");
  refuse(
      !options.range.empty() && by_material,
      "--range is for --colour QUANTITY; materials, families, joints and bonds have no "
      "range");
  refuse(options.figure.arrow_scale && options.figure.arrows.empty(),
         "--arrow-scale is for --arrows");
  const post::QuantityKind* kind = quantities::find_quantity(options.figure.colour);
  refuse(options.compression_positive &&
             (!kind || post::sign_convention(*kind, true).empty()),
         "--compression-positive is for --colour with a stress, such as s22 or p1");
  refuse(!options.figure.colour_map.empty() && by_material,
         "--colormap is for --colour QUANTITY; colours of materials are --materials, "
         "those of joints and bonds are fixed");
  if (!options.figure.colour_map.empty())
    draw::colour_map(options.figure.colour_map);  // throws for an unknown name
  refuse(!options.materials.empty() &&
             (options.figure.shows_quantity() || options.figure.shows_families()),
         "--materials is for --colour material, or a colour of the sides of blocks");
}

/// Reads colours such as "1=RED". Throws std::runtime_error that lists the possible
/// values.
std::map<int, draw::Colour> material_colours(const std::vector<std::string>& texts,
                                             const post::ResultsReader& results) {
  std::map<int, draw::Colour> chosen;
  if (texts.empty())
    return chosen;
  const std::set<int> present = post::materials_of(results);
  for (const std::string& text : split_lists(texts)) {
    const auto mark = text.rfind('=');
    const auto colour =
        mark == text.npos ? std::nullopt : dblock::named_colour(text.substr(mark + 1));
    if (!colour)
      throw std::runtime_error(
          "--materials needs MATERIAL=COLOUR, such as 1=RED, found '" + text +
          "'\n  hint: colours: " + dblock::colour_names());
    const auto material = std::find_if(present.begin(), present.end(), [&](int one) {
      const auto name = results.material_names().find(one);
      return std::to_string(one) == text.substr(0, mark) ||
             (name != results.material_names().end() &&
              name->second == text.substr(0, mark));
    });
    if (material == present.end())
      throw std::runtime_error(fmt::format(
          "there is no material {} in {}\n  hint: materials: {}", text.substr(0, mark),
          results.path(), post::material_list(results)));
    chosen[*material] = *colour;
  }
  return chosen;
}

/// Reads "0.01" or "p90". Throws std::runtime_error for anything else.
post::ArrowScale arrow_scale(const std::string& text) {
  post::ArrowScale scale;
  quantities::Statistic statistic;
  if (CLI::detail::lexical_cast(text, scale.value) && scale.value > 0.0 &&
      std::isfinite(scale.value))
    return scale;
  if (!quantities::Statistic::parse(text, statistic) ||
      statistic.how != quantities::Statistic::How::percentile)
    throw std::runtime_error(
        "--arrow-scale needs a value above 0, or a percentile such as p90, found '" +
        text + "'");
  return {0.0, statistic.percent};
}

void take(const PlotOptions& options, post::FigureOptions& figure) {
  if (!options.zoom.empty())
    figure.zoom = Eigen::Vector4d(options.zoom.data());
  if (!options.range.empty())
    figure.range = Eigen::Vector2d(options.range.data());
  if (!options.arrow_scale.empty())
    figure.arrow_scale = arrow_scale(options.arrow_scale);
  if (options.mirror) {
    figure.mirror = true;
    figure.mirror_x = *options.mirror;
  }
  for (const char* name : {"material", "family", "joint", "bond", "opening",
                           "shear_displacement", "water_pressure"})
    if (text::capitals(figure.colour) == text::capitals(name))
      figure.colour = name;
  figure.page = options.size.page();
}

}  // namespace

void add_plot_options(CLI::App& command, PlotOptions& options) {
  auto& figure = options.figure;
  command.add_option("FILE", options.file, "results of a run, NAME.vtkhdf")->required();
  command.add_option("-o,--output", options.output,
                     "figure: .png, .svg or .pdf; movie: .mp4 or .gif, which need "
                     "ffmpeg (default: NAME.png, with --joints NAME_joints.png)");
  auto* times =
      command
          .add_option(
              "-t,--time", options.times,
              "time of the frame (default: the last, with --joints the first); several "
              "times, separated by commas, are drawn side by side on one sheet or as a "
              "movie")
          ->delimiter(',')
          ->allow_extra_args(false);
  auto* sheet =
      command
          .add_option("--sheet", options.sheet,
                      "draw this many evenly spaced times side by side on one sheet")
          ->check(CLI::Range(1, 100))
          ->excludes(times);
  auto* columns =
      command
          .add_option("--columns", figure.columns,
                      "number of columns of a sheet (default: chosen to fit)")
          ->check(CLI::Range(1, 100));
  auto* from =
      command.add_option("--from", options.from, "first time of a sheet or movie");
  auto* to = command.add_option("--to", options.to, "last time of a sheet or movie");
  auto* every = command
                    .add_option("--every", options.every,
                                "for a movie: draw every Nth frame, and the last")
                    ->check(CLI::Range(1, 1000000000));
  command
      .add_option("--rate", options.rate,
                  "for a movie: pictures per second (default: 25)")
      ->check(CLI::Range(0.1, 100.0));
  command
      .add_option(
          "--colour,--color", figure.colour,
          "material, family (pieces by the block from which they come), joint (the "
          "sides of blocks by joint id), bond (the faces "
          "with the law of a joint: bonded, or failed and how far they slipped), "
          "opening "
          "or shear_displacement (the faces that were closed at first, by their motion "
          "since), water_pressure (the sides that water presses), " +
              quantities::block_quantity_names())
      ->capture_default_str();
  command.add_option("--colormap,--colourmap", figure.colour_map,
                     "colours of a quantity: " + draw::colour_map_names() +
                         " (default: bluered for signed quantities, viridis for "
                         "coordinates, masses and areas, else ylgnbu)");
  command
      .add_option(
          "--materials", options.materials,
          "colours of materials by number or name, such as 1=RED,coal=#303030: " +
              dblock::colour_names())
      ->allow_extra_args(false);
  command.add_option("--range", options.range, "low high: ends of the colour scale")
      ->expected(2)
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_flag("--forces", figure.forces,
                   "draw contact forces: one line for each pair of touching blocks, "
                   "wider for larger forces (with several times, full width is the "
                   "median of their largest forces)");
  command.add_flag("--cracks,!--no-cracks", figure.cracks,
                   "draw the faces of cracks where they are now (default: if there are "
                   "any; --no-cracks: never)");
  command
      .add_option("--arrows", figure.arrows,
                  fmt::format("draw an arrow on each block: {}",
                              fmt::join(post::arrow_names(), ", ")))
      ->check(CLI::IsMember(post::arrow_names()));
  command.add_option(
      "--arrow-scale", options.arrow_scale,
      "the value whose arrow has the full length, such as 0.01, or a percentile of the "
      "values other than 0, such as p90; longer arrows are drawn at full length "
      "(default: the largest value)");
  command.add_flag("--compression-positive", options.compression_positive,
                   "stresses are positive in compression (default: in tension)");
  command.add_option("--title", options.figure.title,
                     "title instead of that of the deck; '' for none");
  command.add_flag("--numbers", figure.numbers, "write the block numbers");
  command.add_flag("--corners", figure.corners, "write the corner numbers");
  command.add_flag("--original", figure.original,
                   "draw the outlines of the first frame underneath");
  command.add_option("--mirror", options.mirror,
                     "also draw the other half, mirrored about this x");
  command
      .add_option("--zoom", options.zoom,
                  "draw only this part: xmin xmax ymin ymax; arrows that leave it end "
                  "at its frame with an open head")
      ->expected(4)
      ->delimiter(',')
      ->allow_extra_args(false);
  add_units_option(command, options.units);
  auto* width = command
                    .add_option("--width", options.size.width,
                                "width of the figure, in pixels or points")
                    ->check(CLI::Range(100, 20000))
                    ->capture_default_str();
  auto* size = command.add_option("--size", options.size.size, draw::PageSize::help())
                   ->excludes(width);
  command.add_flag(
      "--joints", options.joints,
      "draw a rose of joint directions and histograms of block area, aspect ratio and "
      "number of sides, instead of the blocks; used with --output, --time, --title, "
      "--units, --width and --size only");
  command
      .add_option("--dblock", options.dblock,
                  "file of DBLOCK cards (Appendix E of the report), which give a "
                  "series of figures or a movie")
      ->excludes(times)
      ->excludes(sheet)
      ->excludes(columns)
      ->excludes(from)
      ->excludes(to)
      ->excludes(every)
      ->excludes(width)
      ->excludes(size);
  options.command = &command;
}

int plot(PlotOptions options) {
  try {
    if (options.output.empty())
      options.output = std::filesystem::path(options.file).stem().string() +
                       (options.joints ? "_joints.png" : ".png");
    check_ending(options.output);
    files::check_outputs({options.output});
    take(options, options.figure);
    if (options.joints)
      check_options_of_joints(options);
    check_combinations(options);
    post::ResultsReader results(options.file);
    if (options.compression_positive)
      results.make_compression_positive();
    if (!options.units.empty())
      results.show_in(post::parse_units(options.units));
    options.figure.units = results.units();
    options.figure.material_names = results.material_names();
    options.figure.planes = results.planes();
    options.figure.material_colours = material_colours(options.materials, results);
    if (options.joints) {
      const long shown = options.times.empty() ? 0 : results.at(options.times.front());
      post::draw_joints_figure(options.output, results.frame(shown), results.title(),
                               options.figure);
      fmt::print("{}\n", options.output);
      return run::done;
    }
    const double rate = options.rate.value_or(25.0);
    if (!options.dblock.empty())
      return dblock::plot(options.dblock, results, options.output, rate,
                          options.figure);
    const std::vector<long> frames = chosen_frames(results, options);
    post::require_blocks_in_zoom(results, frames, options.figure);
    if (post::is_movie(options.output)) {
      post::draw_movie(options.output, results, frames, rate, options.figure);
      fmt::print("{}: {}, {:.3g} s\n", options.output,
                 counted(frames.size(), "picture"),
                 static_cast<double>(frames.size()) / rate);
    } else {
      options.figure.requested_times = options.times;
      post::draw_figure(options.output, results, frames, options.figure);
      fmt::print("{}\n", options.output);
      if (options.figure.page.printed)
        print_other_times(results, frames, options.figure);
    }
    return run::done;
  } catch (const std::runtime_error& error) {
    return tell_fault(error);
  }
}

}  // namespace blocks::apps
