#include "export_command.hpp"
#include "fault.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

#include "convert/export_scene.hpp"
#include "files/check_outputs.hpp"
#include "files/file_tools.hpp"
#include "post/export/time_series.hpp"
#include "post/read/results_nearby.hpp"
#include "post/read/results_reader.hpp"
#include "run/support/interrupt.hpp"
#include "text/counted.hpp"

namespace blocks::apps {
namespace {

namespace fs = std::filesystem;

/// True if the extension or the first bytes of the file are those of results.
bool is_results(const std::string& path) {
  const auto extension = fs::path(path).extension();
  return extension == ".vtkhdf" || extension == ".h5" ||
         (fs::is_regular_file(path) && post::fault_of_head(path).empty());
}

/// Describes a file that is neither a deck nor results, such as a listing or a binary
/// file. Returns an empty text if the file may be a deck.
std::string neither(const std::string& path) {
  if (!fs::is_regular_file(path))
    return {};  // opening a FIFO may never end
  std::string head(4096, ' ');
  std::ifstream file(path);
  if (!file)
    return {};
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  if (head.find('\0') != std::string::npos)
    return "neither a deck nor results of BLOCKS";
  head.resize(std::min(head.find('\n'), head.size()));
  return head.starts_with("BLOCKS ") && head.ends_with("two-dimensional block motion")
             ? "a listing"
             : "";
}

/// Returns the format by the extension of the output; empty if the extension is
/// unknown.
std::string format_of(const std::string& path) {
  static const std::map<std::string, std::string> formats = {
      {".geojson", "geojson"}, {".json", "geojson"}, {".wkt", "wkt"},
      {".dxf", "dxf"},         {".svg", "svg"},      {".msh", "msh"},
      {".pvd", "pvd"},         {".csv", "csv"},      {".txt", "txt"}};
  const auto found = formats.find(fs::path(path).extension().string());
  return found == formats.end() ? "" : found->second;
}

bool is_series(const std::string& format) { return format == "pvd" || format == "csv"; }

/// Writes all times of the results, or the one that --time gives.
void write_series(const ExportOptions& options, const std::string& format,
                  const post::ResultsReader& results) {
  std::vector<long> frames;
  if (options.time) {
    frames.push_back(results.at(*options.time));
  } else {
    frames.resize(static_cast<std::size_t>(results.frames()));
    std::iota(frames.begin(), frames.end(), 0L);
  }
  run::catch_interrupts();
  const auto write = format == "pvd" ? post::write_pvd : post::write_csv;
  const post::SeriesFiles files =
      write(options.output, results, frames, run::stop_if_interrupted);
  if (!options.input.quiet)
    fmt::print("{}: {}, {} of blocks and {} of contacts\n",
               fmt::join(files.names, ", "), counted(frames.size(), "time"),
               counted(static_cast<std::size_t>(files.blocks), "row"), files.contacts);
}

int refuse(int code, const std::string& message) {
  fmt::print(stderr, "blocks: error: {}\n", message);
  return code;
}

}  // namespace

void add_export_options(CLI::App& command, ExportOptions& options) {
  command
      .add_option("INPUT", options.input.deck,
                  "a deck (its blocks before the first step), or results, "
                  "NAME.vtkhdf")
      ->required();
  command.add_option(
      "-o,--output", options.output,
      ".geojson, .wkt, .dxf, .svg, .msh or .txt (READ9's text form); for "
      "results also .pvd (VTU files) or .csv, both with separate files for the "
      "contacts (default: INPUT's name with .geojson, in this folder)");
  command
      .add_option("--format", options.format,
                  "geojson, wkt, dxf, svg, msh, txt, pvd or csv, whatever the file "
                  "extension")
      ->check(
          CLI::IsMember({"geojson", "wkt", "dxf", "svg", "msh", "txt", "pvd", "csv"}));
  command
      .add_option("--scale", options.scale,
                  "for .svg: 100 draws 1:100 (default: the largest usual scale at "
                  "which the blocks fit on A4); lengths are in m unless UNITS says "
                  "otherwise")
      ->check(CLI::PositiveNumber);
  command.add_option(
      "-t,--time", options.time,
      "for results: time of the frame (default: the last; for .pvd and .csv: all)");
  command.add_option("--seed", options.input.seed,
                     "for a deck: seed of random layers and joints");
  command.add_option("--tape9", options.input.tape9,
                     "for a deck: mesh file for a READ9 card that names none");
  command.add_flag("-q,--quiet", options.input.quiet, "print errors and warnings only");
}

int export_blocks(ExportOptions options) {
  const std::string& input = options.input.deck;
  if (options.output.empty())
    options.output = (input == "-" ? "blocks" : fs::path(input).stem().string()) + "." +
                     (options.format.empty() ? "geojson" : options.format);
  const std::string format =
      options.format.empty() ? format_of(options.output) : options.format;
  if (format.empty())
    return refuse(
        run::usage_error,
        fmt::format("{}: the file extension is not a known format: use "
                    ".geojson, .wkt, .dxf, .svg, .msh, .txt, .pvd or .csv, or "
                    "--format",
                    options.output));
  if (files::same_file(input, options.output))
    return refuse(run::usage_error,
                  input + " would be overwritten: choose another -o NAME");
  files::check_outputs({options.output});

  convert::ExportScene scene;
  if (is_results(input)) {
    if (!options.input.overrides.empty())
      return refuse(run::usage_error,
                    "--set is for decks; the blocks of results are those of a run");
    try {
      const post::ResultsReader results(input);
      if (results.frames() == 0)
        return refuse(run::file_error, input + " has no frames");
      if (is_series(format)) {
        write_series(options, format, results);
        return run::done;
      }
      scene = convert::scene_of(results, options.time);
    } catch (const run::Interrupted&) {
      fmt::print(stderr, "blocks: interrupted; no file was written\n");
      return run::interrupted;
    } catch (const std::runtime_error& fault) {
      return tell_fault(fault);
    }
  } else {
    if (const std::string what = neither(input); !what.empty())
      return refuse(run::file_error, input + " is " + what +
                                         "; export reads results and decks" +
                                         post::results_nearby(input));
    if (options.time)
      return refuse(run::usage_error, "--time is for results; from a deck, the blocks "
                                      "before the first step are exported");
    if (is_series(format))
      return refuse(run::usage_error,
                    "." + format +
                        " is for results: first run the deck with blocks run " + input +
                        ", then export its .vtkhdf");
    const auto checked = run::build_checked(options.input);
    if (checked.code != run::done)
      return checked.code;
    scene = convert::scene_of(checked.model);
  }
  if (scene.blocks.empty())
    return refuse(run::deck_error, input + " has no blocks");

  const exchange::SvgScale scale = convert::scale_of(scene, options.scale);
  std::string text;
  try {
    text = convert::text_of(scene, format, scale, "From " + input);
  } catch (const std::invalid_argument& fault) {
    return refuse(run::deck_error,
                  fmt::format("{}\n  hint: .geojson, .wkt and .txt accept any outline",
                              fault.what()));
  }
  files::replace_file_keeping_older(options.output, text);
  if (!options.input.quiet) {
    fmt::print("{}: {}", options.output, counted(scene.blocks.size(), "block"));
    if (scene.time)
      fmt::print(" at time {:g}", *scene.time);
    if (scene.removed > 0)
      fmt::print("; {} left out",
                 counted(static_cast<std::size_t>(scene.removed), "removed block"));
    if (format == "svg")
      fmt::print("; 1:{:.9g}{}", scale.scale,
                 scene.unit.empty() ? " if lengths are in m" : "");
    const std::string missing = convert::left_out(scene, format);
    fmt::print("{}\n",
               missing.empty() ? "" : "; ." + format + " leaves out " + missing);
  }
  return run::done;
}

}  // namespace blocks::apps
