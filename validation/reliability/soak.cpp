// Many steps of the 850 blocks of decks/subsidence without output: is every number
// finite, is the energy bounded, do blocks at rest stay where they are?
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "dynamics/step.hpp"
#include "geometry/numeric_environment.hpp"
#include "model/model.hpp"
#include "run/run.hpp"

namespace {

using blocks::Blocks;
using blocks::Model;

std::string text(const char* format, auto... values) {
  char line[400];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

/// Kinetic energy and that of the weight, per unit thickness.
double energy(const Model& model) {
  const Blocks& b = model.blocks;
  double sum = 0.0;
  for (int k = 0; k < b.size(); ++k)
    sum += 0.5 * (b.mass[k] * b.velocity.col(k).squaredNorm() +
                  b.inertia[k] * b.spin[k] * b.spin[k]) -
           b.mass[k] * model.settings.gravity.dot(b.centroid.col(k));
  return sum;
}

/// How far the centroids of the free blocks moved, the least first.
std::vector<double> moved(const Blocks& b, const Eigen::Matrix2Xd& before) {
  std::vector<double> way;
  for (int k = 0; k < b.size(); ++k)
    if (b.is_free(k))
      way.push_back((b.centroid.col(k) - before.col(k)).norm());
  std::sort(way.begin(), way.end());
  return way;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"many steps of a deck: finite, bounded, at rest"};
  std::string deck = BLOCKS_SOURCE_DIR "/decks/subsidence/subsidence.deck", report;
  long steps = 10000000;
  app.add_option("--deck", deck, "the deck; its MOTION and CYCLE cards are not used");
  app.add_option("--steps", steps, "time steps")->check(CLI::Range(20L, 1000000000L));
  app.add_option("--report", report, "write NAME.md");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (const auto fault = blocks::geometry::check_numeric_environment();
      !fault.empty()) {
    std::fprintf(stderr, "blocks: error: %s\n", fault.c_str());
    return 1;
  }
  blocks::run::RunOptions options;
  options.deck = deck;
  auto checked = blocks::run::build_checked(options);
  if (checked.code != blocks::run::done)
    return checked.code;

  constexpr long rows = 20;
  Model& model = checked.model;
  blocks::dynamics::SearchBuffers buffers;
  blocks::dynamics::prepare(model);
  std::string table =
      "| step | t | energy above the start | half of the blocks moved less than | "
      "nine in ten | all | largest overlap |\n|---|---|---|---|---|---|---|\n";
  std::printf("%s", table.c_str());
  const double start = energy(model);
  double highest = 0.0, before_last = 0.0, last = 0.0, highest_way = 0.0;
  Eigen::Matrix2Xd before = model.blocks.centroid;
  for (long i = 1; i <= steps; ++i) {
    const bool told = i * rows / steps != (i - 1) * rows / steps;
    const auto step = told ? blocks::dynamics::step : blocks::dynamics::advance;
    if (!step(model, buffers).finite) {
      std::fprintf(stderr, "blocks: error: step %ld: not a number\n", i);
      return 4;
    }
    if (!told)
      continue;
    const double above = energy(model) - start;
    highest = std::max(highest, above);
    const auto way = moved(model.blocks, before);
    before = model.blocks.centroid;
    before_last = last;
    highest_way = std::max(highest_way, way.back());
    last = way[way.size() * 9 / 10];
    const std::string row =
        text("| %ld | %.3f | %.3e | %.1e | %.1e | %.1e | %.2e |\n", i, model.time,
             above, way[way.size() / 2], last, way.back(), model.worst_overlap);
    std::printf("%s", row.c_str());
    std::fflush(stdout);
    table += row;
  }
  const bool bounded = highest <= 0.0;            // falling blocks only lose
  const bool quiet = last <= 1e-6 * highest_way;  // of the way they fell at most
  const std::string verdict = text(
      "%ld steps of %d blocks, %.1f of time: every position finite, energy %s what it "
      "was at the start, and nine in ten of the blocks moved by at most %.1e in the "
      "last "
      "twentieth (%.1e in the one before): %s.\n",
      steps, model.blocks.size(), model.time, bounded ? "never above" : "**above**",
      last, before_last);
  std::printf("\n%s", verdict.c_str());
  if (!report.empty()) {
    std::ofstream out(report + ".md");
    out << "# Soak: the subsidence deck, on and on\n\nWritten by `./go validate soak`; "
           "do not edit. Energy is kinetic and of the weight; ways are those of "
           "centroids since the row before.\n\n"
        << table << "\n"
        << verdict;
    out.flush();
    if (!out) {
      std::fprintf(stderr, "blocks: error: cannot write %s.md\n", report.c_str());
      return 5;
    }
  }
  return bounded && quiet ? 0 : 4;
}
