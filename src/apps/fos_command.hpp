// `blocks fos`: runs a deck that ends in SOLVE and finds its factor of safety.
#pragma once

#include <CLI/App.hpp>
#include <optional>

#include "run/run.hpp"

namespace blocks::apps {

/// The fields of the FOS card.
struct FosOptions {
  std::optional<double> width, ratio, lower, upper;
  std::optional<long> ncycle;
};

void add_fos_options(CLI::App& command, FosOptions& options);

/// Runs the deck with a FOS card behind its last card. Returns an ExitCode.
int find_factor_of_safety(run::RunOptions options, const FosOptions& fos);

}  // namespace blocks::apps
