// `blocks sweep`: the command line of sweeps.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "sweep/engine.hpp"
#include "sweep/make_plan.hpp"

namespace blocks::apps {

struct SweepOptions {
  std::vector<std::string> words;  ///< DECK, DIR, or status DIR
  sweep::Request request;
  std::string output;  ///< folder of a new sweep; empty: NAME.sweep
  bool check = false;  ///< no time steps
  bool study = false;  ///< scenes instead of a deck
  std::string runs;    ///< "40-49"; empty: all
  bool retry = false;  ///< also runs that ended with an error
  sweep::EngineChoice engine;
};

void add_sweep_options(CLI::App& command, SweepOptions& options);

/// Makes a sweep, goes on with one, or shows its status. Returns a code of
/// run::ExitCode.
int sweep(const SweepOptions& options);

}  // namespace blocks::apps
