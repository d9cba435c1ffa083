// Does a wall at rest stay at rest? Runs a deck without output for many steps and
// tells how its kinetic energy and its corners went.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "dynamics/step.hpp"
#include "geometry/numeric_environment.hpp"
#include "model/model.hpp"
#include "run/run.hpp"

namespace {

using blocks::Model;

std::string text(const char* format, auto... values) {
  char line[256];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

double kinetic_energy(const blocks::Blocks& b) {
  double energy = 0.0;
  for (int k = 0; k < b.size(); ++k)
    energy += 0.5 * (b.mass[k] * b.velocity.col(k).squaredNorm() +
                     b.inertia[k] * b.spin[k] * b.spin[k]);
  return energy;
}

/// Energy of all acting springs pressed by the rounding of the largest coordinate, u
/// |x|: less cannot be told from rest.
double energy_of_rounding(const Model& model) {
  const double rounding = 0x1p-53 * model.blocks.corner.cwiseAbs().maxCoeff();
  const auto acting =
      std::count_if(model.contacts.active.begin(), model.contacts.active.end(),
                    [](auto active) { return active != 0; });
  return 0.5 * model.settings.normal_stiffness * rounding * rounding *
         static_cast<double>(acting);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"a deck at rest: kinetic energy and drift over many steps"};
  std::string deck = BLOCKS_SOURCE_DIR "/validation/rest/wall.deck", report;
  long steps = 1000000;
  int rows = 20;
  app.add_option("--deck", deck, "the deck; its MOTION and CYCLE cards are not used");
  app.add_option("--steps", steps, "time steps")->check(CLI::Range(1L, 1000000000L));
  app.add_option("--rows", rows, "rows of the table")->check(CLI::Range(1, 1000));
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

  Model& model = checked.model;
  blocks::dynamics::SearchBuffers buffers;
  blocks::dynamics::prepare(model);
  std::string table =
      "| step | kinetic energy | of rounding | largest movement in a step | moved "
      "since "
      "the last row | acting | searches |\n|---|---|---|---|---|---|---|\n";
  std::printf("%s", table.c_str());
  Eigen::Matrix2Xd before = model.blocks.corner;
  double energy = 0.0, rounding = 0.0, drift = 0.0;
  for (long i = 1; i <= steps; ++i) {
    const bool told = i * rows / steps != (i - 1) * rows / steps;
    const auto step = told ? blocks::dynamics::step : blocks::dynamics::advance;
    const auto moved = step(model, buffers);
    if (!moved.finite) {
      std::fprintf(stderr, "blocks: error: step %ld: not a number\n", i);
      return 4;
    }
    if (!told)
      continue;
    energy = kinetic_energy(model.blocks);
    rounding = energy_of_rounding(model);
    drift = (model.blocks.corner - before).colwise().norm().maxCoeff();
    before = model.blocks.corner;
    const auto acting =
        std::count_if(model.contacts.active.begin(), model.contacts.active.end(),
                      [](auto active) { return active != 0; });
    const std::string row =
        text("| %ld | %.2e | %.1e | %.1e | %.1e | %ld | %ld |\n", i, energy, rounding,
             moved.largest, drift, static_cast<long>(acting), model.search.updates);
    std::printf("%s", row.c_str());
    std::fflush(stdout);
    table += row;
  }
  const bool quiet = energy <= rounding;
  const std::string verdict =
      text("At the end the kinetic energy is %.2e, %s the energy of rounding %.1e; the "
           "corners moved by up to %.1e in the last %ld steps.\n",
           energy, quiet ? "at most" : "above", rounding, drift, steps / rows);
  std::printf("\n%s", verdict.c_str());
  if (!report.empty()) {
    std::ofstream out(report + ".md");
    out << "# A wall of 1,000 bricks at rest\n\nWritten by `./go validate rest`; do "
           "not "
           "edit. What the columns mean: README.md.\n\n"
        << table << "\n"
        << verdict;
    out.flush();
    if (!out) {
      std::fprintf(stderr, "blocks: error: cannot write %s.md\n", report.c_str());
      return 5;
    }
  }
  return quiet ? 0 : 4;
}
