#include "cracks_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "fault.hpp"
#include "files/check_outputs.hpp"
#include "files/file_tools.hpp"
#include "post/chart/cracks_figure.hpp"
#include "post/export/cracks_table.hpp"
#include "post/read/results_reader.hpp"
#include "run/run.hpp"
#include "text/counted.hpp"

namespace blocks::apps {
namespace {

using post::Crack;

/// What is shown: some cracks of a run.
struct ShownCracks {
  const post::ResultsReader& results;
  std::vector<Crack> cracks;

  std::vector<post::NumberTable> table() const {
    post::NumberTable all = post::cracks_table(cracks, results.units(), true);
    all.file = results.path();
    all.title = results.title();
    return {std::move(all)};
  }
};

/// Checks the names of the outputs before the results are read.
void check_crack_outputs(const CracksOptions& options) {
  if ((options.csv || options.json) && !options.outputs.empty())
    throw std::runtime_error(
        "--csv and --json print the numbers, -o writes a file: remove one of them");
  for (const std::string& path : options.outputs) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (ending != ".csv" && ending != ".json" && ending != ".png" && ending != ".svg" &&
        ending != ".pdf")
      throw std::runtime_error(
          "the output's name must end in .csv, .json, .png, .svg or .pdf, found '" +
          path + "'");
    if (files::same_file(path, options.file))
      throw std::runtime_error("-o " + path + " would overwrite the results");
  }
  files::check_outputs(options.outputs);
}

/// Returns the line below the title of the table: "3 cracks (2 by stress, 1 by point
/// loads), energy released 150 J/m".
std::string summary_of(const ShownCracks& shown) {
  if (shown.cracks.empty())
    return "no cracks\n";
  double released = 0.0;
  std::size_t by_points = 0;
  for (const Crack& crack : shown.cracks) {
    released += crack.released();
    by_points += crack.by_points;
  }
  return fmt::format(
      "{} ({} by stress, {} by point loads), energy released {:g} {}\n\n",
      counted(shown.cracks.size(), "crack"), shown.cracks.size() - by_points, by_points,
      released, post::unit_text({1, 1, -2, "J/m", ""}, shown.results.units()));
}

void print_cracks(const ShownCracks& shown, const CracksOptions& options) {
  if (options.csv) {
    std::cout << post::csv_text(shown.table());
  } else if (options.json) {
    std::cout << post::json_text(shown.table());
  } else {
    std::cout << shown.results.title() << " (" << shown.results.path() << ")\n"
              << summary_of(shown);
    if (!shown.cracks.empty())
      std::cout << post::narrow_table_text(
          post::cracks_table(shown.cracks, shown.results.units(), false));
  }
}

void write_cracks(const std::string& path, const ShownCracks& shown,
                  const CracksOptions& options) {
  const auto ending = std::filesystem::path(path).extension();
  if (ending == ".csv") {
    files::replace_file_keeping_older(path, post::csv_text(shown.table()));
  } else if (ending == ".json") {
    files::replace_file_keeping_older(path, post::json_text(shown.table()));
  } else {
    post::FigureOptions figure;
    figure.page = options.size.page();
    figure.title = options.title;
    figure.units = shown.results.units();
    if (shown.cracks.empty())
      throw std::runtime_error(fmt::format(
          "{} has no cracks to draw\n  hint: the card CRACK lets blocks split",
          options.file));
    post::draw_cracks_figure(path, shown.cracks, shown.results.title(), figure);
  }
  fmt::print("{}\n", path);
}

}  // namespace

void add_cracks_options(CLI::App& command, CracksOptions& options) {
  command.add_option("FILE", options.file, "results of a run, NAME.vtkhdf")->required();
  command
      .add_option("-o,--output", options.outputs,
                  "a .csv or .json file with all values, or a .png, .svg or .pdf file "
                  "with a rose of the directions; several are separated by commas "
                  "(default: print a table)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->take_all();
  auto* csv = command.add_flag("--csv", options.csv,
                               "print all values as CSV instead of the table");
  command
      .add_flag("--json", options.json, "print all values as JSON instead of the table")
      ->excludes(csv);
  command.add_option("--from", options.from, "first time");
  command.add_option("--to", options.to, "last time");
  add_units_option(command, options.units);
  command.add_option("--title", options.title,
                     "title of a figure instead of that of the deck; '' for none");
  add_size_options(command, options.size);
}

int cracks(const CracksOptions& options) {
  try {
    if (std::isnan(options.from) || std::isnan(options.to))
      throw std::runtime_error("--from and --to need a number");
    check_crack_outputs(options);
    post::ResultsReader results(options.file);
    if (!options.units.empty())
      results.show_in(post::parse_units(options.units));
    ShownCracks shown{results, results.cracks()};
    std::erase_if(shown.cracks, [&](const Crack& crack) {
      return crack.time < options.from || crack.time > options.to;
    });
    if (options.outputs.empty())
      print_cracks(shown, options);
    for (const std::string& path : options.outputs)
      write_cracks(path, shown, options);
    return run::done;
  } catch (const std::runtime_error& error) {
    return tell_fault(error);
  }
}

}  // namespace blocks::apps
