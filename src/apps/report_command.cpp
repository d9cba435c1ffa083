#include "report_command.hpp"
#include "fault.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "apps/options/common_options.hpp"
#include "apps/options/quoted_list.hpp"
#include "files/check_outputs.hpp"
#include "files/file_tools.hpp"
#include "quantities/quantity.hpp"
#include "report/charts.hpp"
#include "report/page.hpp"
#include "report/tables.hpp"
#include "run/run.hpp"

namespace blocks::apps {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const std::string& path) {
  return fs::path(path).extension().string();
}

bool is_page(const std::string& path) {
  return ending_of(path) == ".html" || ending_of(path) == ".htm";
}

bool is_figure(const std::string& path) {
  return ending_of(path) == ".svg" || ending_of(path) == ".pdf" ||
         ending_of(path) == ".png";
}

report::Request request_of(const ReportOptions& options) {
  report::Request request;
  request.folders = options.folders;
  request.measures = split_lists(options.quantities);
  if (!options.units.empty())
    request.reading.units = post::parse_units(options.units);
  request.reading.compression_positive = options.compression_positive;
  request.reading.frames = options.frames;
  request.pair = options.pair;
  request.mixed = options.mixed;
  request.with_profile = options.profile != "none";
  const bool is_requested = !options.profile.empty() ||
                            options.profile_quantity != "dy" || options.time ||
                            options.mirror;
  if (!request.with_profile || !is_requested)
    return request;
  report::ProfileQuestion question;
  if (!options.profile.empty())
    question.line = post::ProfileLine::parse(options.profile);
  const auto* kind = quantities::find_quantity(options.profile_quantity);
  if (kind == nullptr)
    throw std::runtime_error(
        fmt::format("a profile has no quantity '{}'\n  hint: choose from those of the "
                    "blocks: {}",
                    options.profile_quantity, quantities::quantity_names()));
  question.quantity = kind->name;
  question.time = options.time;
  question.mirror = options.mirror;
  if (question.mirror && (question.line.segment || !std::isfinite(*question.mirror)))
    throw std::runtime_error("--mirror is for --profile top and needs the x of the "
                             "symmetry plane of a half model");
  request.profile = question;
  return request;
}

void check_names(const ReportOptions& options) {
  std::vector<std::string> all = options.outputs;
  for (const std::string& path : options.outputs)
    if (!is_page(path) && !is_figure(path) && ending_of(path) != ".csv" &&
        ending_of(path) != ".json")
      throw std::runtime_error(
          "the report's name must end in .html, .csv, .json, .svg, "
          ".pdf or .png, found '" +
          path + "'");
  if (!options.runs.empty()) {
    if (ending_of(options.runs) != ".csv")
      throw std::runtime_error("the table of --run-table must end in .csv, found '" +
                               options.runs + "'");
    all.push_back(options.runs);
  }
  files::check_outputs(all);
}

/// Returns the folder of a file; "." for one in this folder.
std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

void write_page(const std::string& path, const report::Ensemble& ensemble,
                const report::Analysis& analysis, const ReportOptions& options) {
  const auto typical = report::typical_runs(ensemble, analysis);
  const report::RunPages runs = report::write_run_pages(
      ensemble, analysis, typical, static_cast<std::size_t>(options.pages));
  if (!runs.fault.empty())
    fmt::print(stderr, "blocks: warning: runs have no pages: {}\n", runs.fault);
  files::replace_file_keeping_older(
      path, report::report_page(ensemble, analysis, typical, runs,
                                {options.title, folder_of(path)}));
}

/// Writes one file for each chart: "trough.pdf" becomes "trough-profile.pdf".
void write_figures(const std::string& path, const report::Ensemble& ensemble,
                   const report::Analysis& analysis, const ReportOptions& options) {
  const draw::PageSize page =
      draw::PageSize::in_print(options.size.empty() ? "double" : options.size);
  const std::string stem = fs::path(path).replace_extension().string();
  for (const report::NamedChart& named : report::all_charts(ensemble, analysis)) {
    const std::string file = fmt::format("{}-{}{}", stem, named.name, ending_of(path));
    std::visit([&](const auto& one) { draw::draw_chart(file, one, page); },
               named.chart);
    fmt::print("{}\n", file);
  }
}

}  // namespace

void add_report_options(CLI::App& command, ReportOptions& options) {
  command.add_option("DIR", options.folders, "folders of sweeps")->required();
  command
      .add_option(
          "-q,--quantity", options.quantities,
          "quantities of each run, separated by commas: as for blocks history (y:9, "
          "speed:max, kinetic_energy) at the end of the run, CURVE@0.5 at a time, "
          "CURVE@max or CURVE@min over time; profile:min or profile:max; measures of "
          "the generated blocks (p21, aspect:max); 'dy:min<-1' is the share of the "
          "runs with a value below -1 (default: what the HISTORY card recorded, "
          "otherwise dy:min, displacement:max, overlap@max, kinetic_energy and "
          "contacts; profile:min before them)")
      ->allow_extra_args(false)
      ->take_all();
  command
      .add_option("-o,--output", options.outputs,
                  ".html (the page), .csv or .json (its statistics), or .svg, .pdf or "
                  ".png (its figures, each in a file of its own, NAME-FIGURE.svg); "
                  "several are separated by commas (default: DIR/report.html)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->take_all();
  command.add_option("--run-table", options.runs,
                     "also write a CSV with a row for each run: parameters, seed, exit "
                     "code, message, values");
  command.add_option(
      "--profile", options.profile,
      "draw the median and the band of a quantity along top (the upper surface of the "
      "model) or x0,y0,x1,y1 (a line); none: no profile (default: top)");
  command.add_option("--profile-quantity", options.profile_quantity,
                     "quantity of the profile (default: dy)");
  command.add_option("--time", options.time,
                     "time of the profile (default: the end of the runs)");
  command.add_option("--mirror", options.mirror,
                     "for --profile top: add the other half of a half model, mirrored "
                     "about this x");
  command.add_option(
      "--precision", options.precision,
      "half width of the 95 % interval of a mean for which the number of "
      "runs is estimated: a part of the mean, 5%, or a value, 0.01 "
      "(default: 5%)");
  auto* pair =
      command.add_flag("--pair", options.pair,
                       "compare two sweeps by seed, whatever their decks; the "
                       "differences are those of the second one from the first one");
  command
      .add_flag("--mixed", options.mixed,
                "show sweeps of different decks, versions or numerics side by side")
      ->excludes(pair);
  command
      .add_option("--pages", options.pages,
                  "most runs that have a page which plays them, as blocks view writes "
                  "it; if there are more, only the median and extreme runs have one, "
                  "and the others a page with the last picture and the log (up to "
                  "2000 runs, then the log)")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  add_units_option(command, options.units);
  command.add_option("--size", options.size, draw::PageSize::help());
  command.add_option("--title", options.title,
                     "title of the page instead of that of the deck");
  command.add_flag("--compression-positive", options.compression_positive,
                   "stresses are positive in compression (default: in tension)");
  command.add_flag("--frames", options.frames,
                   "use the frames even if a HISTORY card recorded the quantities");
  command.add_flag("--quiet", options.quiet, "do not print the table");
  command.footer("Quantities " + quantities::history_help());
}

int report(ReportOptions options) {
  try {
    if (options.outputs.empty())
      options.outputs = {(fs::path(options.folders.front()) / "report.html").string()};
    const report::Precision precision = report::Precision::parse(options.precision);
    const report::Request request = request_of(options);
    for (const std::string& folder : options.folders)
      if (!sweep::has_plan(folder))
        sweep::read_plan(folder);  // throws
    check_names(options);
    const report::Ensemble ensemble = report::read_ensemble(request);
    const report::Analysis analysis = report::analyse(ensemble, precision);
    if (!options.quiet)
      std::cout << report::statistics_text(ensemble, analysis) << '\n';
    for (const std::string& path : options.outputs) {
      if (is_figure(path)) {
        write_figures(path, ensemble, analysis, options);
        continue;
      }
      if (is_page(path))
        write_page(path, ensemble, analysis, options);
      else
        files::replace_file_keeping_older(
            path, ending_of(path) == ".csv"
                      ? report::statistics_csv(ensemble, analysis)
                      : report::statistics_json(ensemble, analysis));
      fmt::print("{}\n", path);
    }
    if (!options.runs.empty()) {
      files::replace_file_keeping_older(options.runs, report::runs_csv(ensemble));
      fmt::print("{}\n", options.runs);
    }
    return run::done;
  } catch (const std::runtime_error& error) {
    return tell_fault(error);
  }
}

}  // namespace blocks::apps
