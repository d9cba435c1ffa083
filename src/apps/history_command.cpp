#include "history_command.hpp"
#include "fault.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include "apps/options/quoted_list.hpp"
#include "draw/chart/line_chart.hpp"
#include "draw/number_text.hpp"
#include "files/check_outputs.hpp"
#include "files/file_tools.hpp"
#include "post/chart/history.hpp"
#include "post/chart/history_lines.hpp"
#include "post/chart/open_run.hpp"
#include "post/chart/profile.hpp"
#include "post/export/number_table.hpp"
#include "post/read/crack_tracker.hpp"
#include "run/run.hpp"

namespace blocks::apps {
namespace {

namespace fs = std::filesystem;
using post::NumberTable;

/// Returns "tension positive" or "compression positive" for a stress, otherwise an
/// empty text.
std::string sign_of(const std::string& quantity, bool compression_positive) {
  const post::QuantityKind* kind = quantities::find_quantity(quantity);
  const std::string sign =
      kind ? post::sign_convention(*kind, compression_positive) : "";
  return sign.substr(std::min(sign.size(), sign.find_first_not_of(", ")));
}

/// The numbers for the tables and the lines for the figure.
struct Answer {
  std::vector<NumberTable> runs;
  draw::Chart chart;
};

/// Returns the units of all runs: those of --units, otherwise those of the first run.
/// Throws std::runtime_error if only some of the decks name their units.
std::optional<Units> common_units(const HistoryOptions& options) {
  if (!options.units.empty())
    return post::parse_units(options.units);
  std::optional<Units> units;
  std::string with, without;
  for (const std::string& file : options.files) {
    const auto of_file = post::ResultsReader(file).units();
    (of_file ? with : without) = file;
    if (!units)
      units = of_file;
  }
  if (!with.empty() && !without.empty())
    throw std::runtime_error(fmt::format(
        "{} is in {}, but the deck of {} has no UNITS card\n  hint: --units {} means "
        "that all of them are in these units, or converts",
        with, post::names_of(*post::ResultsReader(with).units()), without,
        post::names_of(*units)));
  return units;
}

void set_heading(draw::Chart& chart, const std::vector<NumberTable>& runs,
                 const HistoryOptions& options) {
  std::vector<std::string> titles;
  for (const NumberTable& run : runs)
    if (std::find(titles.begin(), titles.end(), run.title) == titles.end())
      titles.push_back(run.title);
  chart.title = fmt::format("{}", fmt::join(titles, "  ·  "));
  if (chart.title.empty())
    chart.title = "BLOCKS";
  chart.title = options.title.value_or(chart.title);
  if (!options.paths)
    return;
  for (const NumberTable& run : runs)
    chart.subtitle += (chart.subtitle.empty() ? "" : ", ") + run.file;
}

post::Curve parse(const std::string& text) {
  try {
    return quantities::parse_curve(text);
  } catch (const quantities::CurveFault& fault) {
    std::string hint = fault.hint;
    for (auto end = hint.find('\n'); end != hint.npos; end = hint.find('\n', end + 1))
      hint.insert(end + 1, "        ");
    throw std::runtime_error(std::string(fault.what()) + "\n  hint: " + hint);
  }
}

/// Returns the curves that are shown if none are named: those that the first run
/// recorded, otherwise the usual ones.
std::vector<post::Curve> overview(const HistoryOptions& options) {
  std::vector<post::Curve> curves;
  if (!options.frames)
    curves = post::recorded_curves(post::ResultsReader(options.files.front()));
  if (curves.empty())
    for (const char* usual : quantities::usual_curves)
      curves.push_back(quantities::parse_curve(usual));
  return curves;
}

Answer histories(const HistoryOptions& options, const std::optional<Units>& units) {
  std::vector<post::Curve> curves;
  const bool against = !options.against.empty();
  if (against)
    curves.push_back(parse(options.against));
  for (const std::string& text : options.quantities)
    curves.push_back(parse(text));
  if (options.quantities.empty())
    for (const post::Curve& curve : overview(options))
      curves.push_back(curve);

  Answer answer;
  std::vector<post::RunLine> lines;
  const auto runs = post::join_parts(options.files);
  const auto names = post::run_names(runs);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const post::OpenRun run(runs[r], units, options.compression_positive);
    const post::History history =
        post::read_history(run.parts(), curves, {options.from, options.to},
                           options.frames, run.material_numbers());
    if (!history.without_samples.empty())
      fmt::print(stderr,
                 "blocks history: the curves of {} are those of its frames: {}\n",
                 history.file, history.without_samples);
    const std::string time_unit = post::unit_text({0, 0, 1, "s", ""}, units);
    NumberTable table{
        history.file, history.title, {{"time", "time", time_unit, history.time}}};
    for (std::size_t i = 0; i < history.series.size(); ++i) {
      const post::Series& series = history.series[i];
      const std::string unit = post::unit_text(series.dimension, units);
      table.columns.push_back(
          {series.curve.name(), series.label, unit, series.values,
           sign_of(series.curve.quantity, options.compression_positive)});
      if (against && i == 0)
        continue;
      lines.push_back({draw::with_unit(series.quantity, unit), series.label,
                       post::legend_of(series.label, names[r]),
                       against ? history.series.front().values : history.time,
                       series.values,
                       quantities::is_of_equilibrium(series.curve.quantity)});
    }
    const auto& x = table.columns[against ? 1 : 0];
    answer.chart.x_label = draw::with_unit(x.label, x.unit);
    answer.runs.push_back(std::move(table));
  }
  answer.chart.panels = post::panels_of(lines, !against && !options.each_run);
  set_heading(answer.chart, answer.runs, options);
  return answer;
}

/// A frame of a profile, and the time asked for.
struct ProfileFrame {
  post::Frame frame;
  std::optional<double> requested;
};

/// Returns the frames nearest to the given times; the last frame if none are given.
std::vector<ProfileFrame> frames_at(const post::OpenRun& run,
                                    const std::vector<double>& times) {
  if (times.empty())
    return {{run.last().frame(run.last().frames() - 1), std::nullopt}};
  std::vector<ProfileFrame> frames;
  for (const double time : times)
    frames.push_back({run.at(time).frame(run.at(time).at(time)), time});
  return frames;
}

Answer profiles(const HistoryOptions& options, const std::optional<Units>& units) {
  const auto line = post::ProfileLine::parse(options.profile);
  std::vector<const post::QuantityKind*> kinds;
  for (const std::string& name : options.quantities.empty()
                                     ? std::vector<std::string>{"dy"}
                                     : options.quantities) {
    kinds.push_back(quantities::find_quantity(name));
    if (!kinds.back())
      throw std::runtime_error(
          "a profile has no quantity '" + name +
          "': choose from those of the blocks: " + quantities::quantity_names());
  }
  Answer answer;
  std::vector<post::RunLine> lines;
  const auto runs = post::join_parts(options.files);
  const auto names = post::run_names(runs);
  const std::string length = post::unit_text({1, 0, 0, "m", ""}, units);
  const std::string position = line.segment ? "distance along the line" : "x";
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const post::OpenRun run(runs[r], units, options.compression_positive);
    const post::Frame first = run.first().frame(0);
    auto places = post::profile_places(first, line);
    if (options.mirror)
      places = post::both_halves(places, *options.mirror);
    NumberTable table{fmt::format("{}", fmt::join(runs[r].files, " + ")),
                      run.first().title(),
                      {{"position", position, length, {}}}};
    table.columns.push_back({"block", "block", "", {}});
    for (const post::ProfilePlace& place : places) {
      table.columns[0].values.push_back(place.position);
      table.columns[1].values.push_back(place.block);
    }
    for (const auto& [now, requested] : frames_at(run, options.times)) {
      const post::Frame before = post::cracked_blocks(run.parts(), now).first;
      for (const post::QuantityKind* kind : kinds) {
        const std::string unit = post::unit_text(kind->dimension, units);
        const std::string at = fmt::format("{:.4g}", now.time);
        table.columns.push_back({kind->name + "@" + at, kind->label + " at time " + at,
                                 unit, post::profile_values(places, *kind, now, before),
                                 sign_of(kind->name, options.compression_positive)});
        lines.push_back(
            {draw::with_unit(kind->label +
                                 post::sign_convention(*kind, now.compression_positive),
                             unit),
             post::time_text(requested.value_or(now.time), std::nullopt, units),
             post::legend_of(post::time_text(now.time, requested, units), names[r]),
             table.columns[0].values, table.columns.back().values});
      }
    }
    answer.runs.push_back(std::move(table));
  }
  answer.chart.panels = post::panels_of(lines, !options.each_run);
  answer.chart.x_label = draw::with_unit(position, length);
  set_heading(answer.chart, answer.runs, options);
  return answer;
}

/// Checks the names of the outputs before any file is read.
void check_names(const std::vector<std::string>& outputs) {
  for (const std::string& path : outputs) {
    const std::string ending = fs::path(path).extension().string();
    if (ending != ".csv" && ending != ".json" && ending != ".png" && ending != ".svg" &&
        ending != ".pdf")
      throw std::runtime_error(
          "the output's name must end in .csv, .json, .png, .svg or .pdf, found '" +
          path + "'");
  }
  files::check_outputs(outputs);
}

void write(const std::string& path, const Answer& answer, const draw::PageSize& page) {
  const std::string ending = fs::path(path).extension().string();
  if (ending == ".csv")
    files::replace_file_keeping_older(path, post::csv_text(answer.runs));
  else if (ending == ".json")
    files::replace_file_keeping_older(path, post::json_text(answer.runs));
  else
    draw::draw_chart(path, answer.chart, page);
  fmt::print("{}\n", path);
}

void print(const Answer& answer, const HistoryOptions& options) {
  if (options.csv)
    std::cout << post::csv_text(answer.runs);
  else if (options.json)
    std::cout << post::json_text(answer.runs);
  else
    for (const NumberTable& run : answer.runs)
      std::cout << post::table_text(run);
}

}  // namespace

void add_history_options(CLI::App& command, HistoryOptions& options) {
  command.add_option("FILE", options.files, "results of one or more runs, NAME.vtkhdf")
      ->required();
  command
      .add_option(
          "-q,--quantity", options.quantities,
          "quantities, separated by commas: speed:9 (block 9), y:9.2 (its corner 2), "
          "y:6-9, y:6-9/12 or y:material=2 (the mean of these blocks), y:6-9:p90 "
          "(their 90th percentile), speed:max, :min, :mean, :sum or :p90 (all blocks), "
          "kinetic_energy (the model), \"y:material=soft, wet clay\" (a name with "
          "commas) (default: what the HISTORY card recorded, "
          "otherwise kinetic_energy,overlap,contacts)")
      ->allow_extra_args(false)
      ->take_all();
  command.add_option(
      "--against", options.against,
      "quantity on the horizontal axis instead of time, written as for -q");
  command.add_flag("--frames", options.frames,
                   "use the frames even if a HISTORY card recorded the quantities");
  command.add_option("--from", options.from, "first time");
  command.add_option("--to", options.to, "last time");
  command.add_option(
      "--profile", options.profile,
      "quantities along top (the upper surface of the model) or x0,y0,x1,y1 (a line) "
      "instead of over time; the default of -q is then dy");
  command
      .add_option("-t,--times", options.times,
                  "times of a profile, separated by commas (default: the last)")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option(
      "--mirror", options.mirror,
      "for --profile top: add the other half of a half model, mirrored about this x");
  command
      .add_option("-o,--output", options.outputs,
                  "a .csv, .json, .png, .svg or .pdf file; several are separated by "
                  "commas (default: print a table)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->take_all();
  auto* csv = command.add_flag("--csv", options.csv, "print CSV instead of the table");
  command.add_flag("--json", options.json, "print JSON instead of the table")
      ->excludes(csv);
  add_units_option(command, options.units);
  command.add_option("--title", options.title,
                     "title of a figure instead of those of the decks; '' for none");
  command.add_flag("--compression-positive", options.compression_positive,
                   "stresses are positive in compression (default: in tension)");
  command.add_flag(
      "--each-run", options.each_run,
      "draw the curves of all runs (default: a median and the band of 5 to "
      "95 % if there are more than 8 runs)");
  command.add_flag("--paths", options.paths,
                   "write the paths of the results under the title of a figure");
  add_size_options(command, options.size);
  command.footer("Quantities " + quantities::history_help());
}

int history(HistoryOptions options) {
  try {
    options.quantities = split_lists(options.quantities);
    options.against = fmt::format("{}", fmt::join(split_lists({options.against}), ","));
    if (!options.times.empty() && options.profile.empty())
      throw std::runtime_error(
          "--times is for --profile; limit a history with --from and --to");
    if (!options.profile.empty() &&
        (!options.against.empty() || std::isfinite(options.from) ||
         std::isfinite(options.to)))
      throw std::runtime_error("--against, --from and --to are for a history; give the "
                               "times of a --profile with --times");
    if (std::isnan(options.from) || std::isnan(options.to))
      throw std::runtime_error("--from and --to need a number");
    if ((options.csv || options.json) && !options.outputs.empty())
      throw std::runtime_error(
          "--csv and --json print the numbers, -o writes a file: remove one of them");
    for (const std::string& path : options.outputs)
      for (const std::string& file : options.files)
        if (std::error_code none; fs::equivalent(path, file, none))
          throw std::runtime_error("-o " + path + " would overwrite the results " +
                                   file);
    if (options.mirror && (options.profile != "top" || !std::isfinite(*options.mirror)))
      throw std::runtime_error("--mirror is for --profile top and needs the x of the "
                               "symmetry plane of a half model");
    check_names(options.outputs);
    const std::optional<Units> units = common_units(options);
    const draw::PageSize page = options.size.page();
    const Answer answer =
        options.profile.empty() ? histories(options, units) : profiles(options, units);
    if (options.outputs.empty())
      print(answer, options);
    for (const std::string& path : options.outputs)
      write(path, answer, page);
    return run::done;
  } catch (const std::runtime_error& error) {
    return tell_fault(error);
  }
}

}  // namespace blocks::apps
