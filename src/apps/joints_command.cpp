#include "joints_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include "apps/options/option_checks.hpp"
#include "fault.hpp"
#include "files/check_outputs.hpp"
#include "files/file_tools.hpp"
#include "joints/fit_report.hpp"
#include "joints/map_figure.hpp"
#include "joints/statistics.hpp"
#include "run/run.hpp"
#include "text/counted.hpp"

namespace blocks::apps {
namespace {

/// Reads "x1,y1,x2,y2".
joints::Scanline scanline_of(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : CLI::detail::split(text, ','))
    if (const auto number = geometry::Decimal::parse(CLI::detail::trim_copy(part)))
      numbers.push_back(number->value());
  const bool complete =
      numbers.size() == 4 && std::count(text.begin(), text.end(), ',') == 3;
  if (!complete || (numbers[0] == numbers[2] && numbers[1] == numbers[3]))
    throw std::runtime_error(
        "--scanline needs two different points, x1,y1,x2,y2, found "
        "'" +
        text + "'");
  return {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

/// Checks the names of the outputs before the maps are read.
void check_joint_outputs(const JointsOptions& options,
                         const std::vector<std::string>& outputs) {
  for (const std::string& path : outputs)
    for (const auto* inputs : {&options.input.files, &options.input.outlines})
      for (const std::string& input : *inputs)
        if (files::same_file(path, input))
          throw std::runtime_error("-o " + path + " would overwrite an input");
  files::check_outputs(outputs);
}

/// Checks that names end as they must.
void check_endings(const std::vector<std::string>& names,
                   const std::set<std::string>& endings, const std::string& in_words) {
  for (const std::string& name : names)
    if (!endings.contains(std::filesystem::path(name).extension().string()))
      throw std::runtime_error("the output's name must end in " + in_words +
                               ", found '" + name + "'");
}

/// Calls the command. Reports what it throws, and returns the exit code.
template <class Command> int guarded(const Command& command) {
  try {
    return command();
  } catch (const geometry::CutError& fault) {
    fmt::print(stderr, "blocks: error: {}, at ({:.6g}, {:.6g})\n  hint: {}\n",
               fault.what(), fault.place.x(), fault.place.y(), fault.hint);
    return run::deck_error;
  } catch (const std::runtime_error& error) {
    return tell_fault(error);
  }
}

void add_input_options(CLI::App& command, convert::MapInput& input) {
  command
      .add_option(
          "--outline", input.outlines,
          "window in which the traces were mapped: GeoJSON, WKT or DXF with one "
          "polygon (default: the box of the traces; for a deck, its OUTLINE)")
      ->allow_extra_args(false)
      ->take_all();
  command
      .add_option(
          "--snap", input.snap,
          "for a file of traces: ends that stop short of a trace, or overshoot it, "
          "by at most this length meet it")
      ->check(length_from_zero());
  command
      .add_option("--seed", input.seed,
                  "for a deck: seed of its joints; replaces that of the SEED card")
      ->check(seed_number());
}

void add_shortest_option(CLI::App& command, double& shortest) {
  command
      .add_option("--shortest", shortest,
                  "length of the shortest traces that were mapped everywhere; shorter "
                  "ones are left out of laws of length (default: 0)")
      ->check(length_from_zero());
}

/// Warns of what makes the counts of a map doubtful.
void tell_doubts(const std::string& name, const joints::Network& network) {
  const auto warn = [&](std::size_t count, const std::string& what,
                        const std::string& hint) {
    if (count > 0)
      fmt::print(stderr, "blocks: warning: {}: {} {}\n  hint: {}\n", name, count, what,
                 hint);
  };
  warn(network.overlaps, "ends where a trace coincides with another one",
       "draw each trace once");
  warn(network.nodes.joined,
       "places where the ends of two traces meet; they count as no node",
       "draw one trace there, or prolong one of them to a third");
  warn(network.nodes.more, "nodes with more than four branches; they count as X",
       "look whether traces meet there in one point");
}

}  // namespace

void add_joint_statistics_options(CLI::App& command, JointsOptions& options) {
  command
      .add_option(
          "INPUT", options.input.files,
          "files of traces (GeoJSON, WKT, DXF, CSV) and decks, whose joints are "
          "taken before they are cut; several are columns of one table")
      ->required();
  add_input_options(command, options.input);
  add_shortest_option(command, options.shortest);
  command
      .add_option("--scanline", options.scanlines,
                  "a scanline x1,y1,x2,y2; may be repeated (lines along x and y, and "
                  "across each family, are always counted)")
      ->type_name("X1,Y1,X2,Y2")
      ->allow_extra_args(false)
      ->take_all();
  command
      .add_option(
          "-o,--output", options.outputs,
          "a .json file with all numbers, or a .png, .svg or .pdf file with rose, "
          "triangle of nodes and histograms; several are separated by commas "
          "(default: print a table)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->take_all();
  command.add_flag("--json", options.json,
                   "print all numbers as JSON instead of the table");
  add_size_options(command, options.size);
}

void add_joint_fit_options(CLI::App& command, JointsOptions& options) {
  command
      .add_option("INPUT", options.input.files,
                  "a file of traces (GeoJSON, WKT, DXF, CSV), or a deck with one group "
                  "OUTLINE ... CUT")
      ->required()
      ->expected(1);
  add_input_options(command, options.input);
  add_shortest_option(command, options.shortest);
  command
      .add_option("-o,--output", options.deck,
                  "the deck to write (default: INPUT's name with _fit.deck, in this "
                  "folder)")
      ->type_name("NAME.deck");
  command.add_flag("--json", options.json,
                   "print all numbers as JSON instead of the table");
}

int joint_statistics(const JointsOptions& options) {
  return guarded([&] {
    joints::StatisticsOptions how;
    how.shortest = options.shortest;
    for (const std::string& line : options.scanlines)
      how.scanlines.push_back(scanline_of(line));
    check_endings(options.outputs, {".json", ".png", ".svg", ".pdf"},
                  ".json, .png, .svg or .pdf");
    const draw::PageSize page = options.size.page();
    check_joint_outputs(options, options.outputs);
    const convert::ReadMaps read = convert::read_maps(options.input);
    if (read.code != run::done)
      return read.code;
    std::vector<joints::MapStatistics> maps;
    for (const joints::TraceMap& map : read.maps) {
      maps.push_back(joints::statistics_of(map, how));
      tell_doubts(map.name, maps.back().network);
    }
    for (const std::string& path : options.outputs) {
      if (std::filesystem::path(path).extension() == ".json")
        files::replace_file_keeping_older(path, joints::statistics_json(maps));
      else
        joints::draw_map_figure(path, maps, page);
      fmt::print("{}\n", path);
    }
    if (options.json)
      std::cout << joints::statistics_json(maps);
    else if (options.outputs.empty())
      std::cout << joints::statistics_text(maps);
    return static_cast<int>(run::done);
  });
}

int fit_joints(const JointsOptions& options) {
  return guarded([&] {
    const std::string& input = options.input.files.front();
    std::string deck = options.deck;
    if (deck.empty())
      deck = (input == "-" ? "joints" : std::filesystem::path(input).stem().string()) +
             "_fit.deck";
    check_endings({deck}, {".deck"}, ".deck");
    check_joint_outputs(options, {deck});
    const convert::ReadMaps read = convert::read_maps(options.input);
    if (read.code != run::done)
      return read.code;
    if (read.maps.size() > 1)
      throw std::runtime_error(fmt::format(
          "{} has {} groups OUTLINE ... CUT, and one map is fitted\n  hint: "
          "give a deck with one group",
          input, read.maps.size()));
    const joints::TraceMap& map = read.maps.front();
    const joints::Network network = joints::network_of(map);
    if (network.pieces.empty())
      throw std::runtime_error(map.name + ": no trace is inside the window\n  hint: "
                                          "give traces and window in the same "
                                          "coordinates");
    tell_doubts(map.name, network);
    const joints::NetworkFit fit = joints::fit_sets(network, options.shortest);
    if (fit.sets.empty())
      throw std::runtime_error(fmt::format(
          "{}: {} of traces show{} no family of directions, and no joint set\n  hint: "
          "a set needs at least three traces; give a larger map",
          map.name, counted(network.pieces.size(), "part"),
          network.pieces.size() == 1 ? "s" : ""));
    files::replace_file_keeping_older(deck, joints::fit_deck(fit, map, network));
    std::cout << (options.json ? joints::fit_json(fit, map)
                               : joints::fit_text(fit) + "written: " + deck + "\n");
    return static_cast<int>(run::done);
  });
}

}  // namespace blocks::apps
