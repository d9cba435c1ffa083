// Measures times of the program, alone and against other codes: ./go validate bench.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "files/check_outputs.hpp"
#include "files/file_error.hpp"
#include "geometry/numeric_environment.hpp"
#include "parts.hpp"
#include "scene_table.hpp"

namespace {

using namespace blocks::bench;

struct Options {
  std::vector<std::string> parts;
  std::string output = "bench";
  bool quick = false;
  int rounds = 0;   // 0: five, or three if quick
  int largest = 0;  // 0: six, or four if quick
};

std::string names() {
  std::string all;
  for (const Part& part : parts())
    all += (all.empty() ? "" : ", ") + std::string(part.name);
  return all;
}

/// Renames an existing file to NAME.bak.
void keep_older(const std::string& path) {
  if (std::filesystem::exists(path))
    std::filesystem::rename(path, path + ".bak");
}

bool write(const std::string& path, const std::string& text) {
  keep_older(path);
  std::ofstream out(path);
  out << text;
  out.flush();
  if (!out)
    fmt::print(stderr, "blocks: error: cannot write {}\n", path);
  return static_cast<bool>(out);
}

Plan plan_of(const Options& options) {
  Plan plan;
  if (options.quick) {
    plan.rounds = 3;
    plan.seconds = 0.05;
    plan.largest = 4;
    plan.polygons = 200;
    plan.whole_decks = false;
  }
  if (options.rounds > 0)
    plan.rounds = options.rounds;
  if (options.largest > 0) {
    plan.largest = options.largest;
    plan.smallest = std::min(plan.smallest, plan.largest);
  }
  return plan;
}

bool is_asked_for(const Part& part, const Options& options) {
  return options.parts.empty() || std::find(options.parts.begin(), options.parts.end(),
                                            part.name) != options.parts.end();
}

int run(const Options& options) {
  // Fails now rather than after minutes of work.
  blocks::files::check_outputs(
      {options.output + ".md", options.output + ".json", options.output + ".png"});
  const Plan plan = plan_of(options);
  Report report;
  report.quick = options.quick;
  report.rounds = plan.rounds;
  std::string text;
  const auto say = [&text](const std::string& more) {
    fmt::print("{}", more);
    std::fflush(stdout);
    text += more;
  };
  say(fmt::format(
      "# Times\n\nWritten by `./go bench`; do not edit. Medians of {} "
      "rounds in which the codes take turns; one thread on processor time, more, "
      "and one beside them, on the clock.\n",
      plan.rounds));
  bool headed = false, failed = false;
  for (const Part& part : parts())
    if (is_asked_for(part, options)) {
      const std::string name(part.name);
      try {
        part.run(plan, report);
      } catch (const std::exception& error) {
        // The times of the other parts are kept.
        report.notes.push_back(
            fmt::format("The part {} failed: {}", name, error.what()));
        fmt::print(stderr, "blocks: error: {}\n", report.notes.back());
        failed = true;
        continue;
      }
      if (part.scenes && !std::exchange(headed, true))
        say(heading_of_scenes());
      say(part.scenes ? rows_of_scenes(report, name) : table_of(report, name));
    }
  say(table_of_targets(report));
  for (const std::string& note : report.notes)
    say(fmt::format("\n{}.\n", note));
  if (!write(options.output + ".json", to_json(report).dump(2) + "\n") ||
      !write(options.output + ".md", text))
    return 5;
  const bool drawn = draw_scenes(report, options.output + ".png");
  fmt::print(stderr, "wrote {0}.md, {0}.json{1}\n", options.output,
             drawn ? ", " + options.output + ".png" : "");
  return failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"times of the program, alone and against other codes", "./go bench"};
  Options options;
  std::string what = "parts to run, all if none is named:";
  for (const Part& part : parts())
    what += fmt::format("\n  {:<11} {}", part.name, part.what);
  app.add_option("part", options.parts, what);
  app.add_option("-o,--output", options.output, "writes NAME.md, NAME.json, NAME.png")
      ->capture_default_str();
  app.add_flag("--quick", options.quick, "small sizes and short turns: a minute");
  app.add_option("--rounds", options.rounds, "turns of each code (5; quick: 3)")
      ->check(CLI::Range(1, 1000));
  app.add_option("--largest", options.largest,
                 "largest size, 10 to this power of blocks (6; quick: 4)")
      ->check(CLI::Range(2, 7));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0)
      return app.exit(error);
    fmt::print(stderr, "blocks: error: {}; --help shows the options\n", error.what());
    return 2;
  }
  for (const std::string& name : options.parts)
    if (std::none_of(parts().begin(), parts().end(),
                     [&](const Part& part) { return part.name == name; })) {
      fmt::print(stderr, "blocks: error: no benchmark '{}'; there are: {}\n", name,
                 names());
      return 2;
    }
  if (const auto fault = blocks::geometry::check_numeric_environment();
      !fault.empty()) {
    fmt::print(stderr, "blocks: error: {}\n", fault);
    return 1;
  }
  try {
    return run(options);
  } catch (const blocks::files::FileError& error) {
    fmt::print(stderr, "blocks: error: {}\n", error.what());
    return 5;
  } catch (const std::exception& error) {
    fmt::print(stderr, "blocks: error: {}\n", error.what());
    return 1;
  }
}
