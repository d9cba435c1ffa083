// `blocks manual`: generates man pages and bash completion. They come from the tables
// that the program itself uses, so they always agree with it.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace blocks::apps {

struct ManualOptions {
  std::string page;
  std::string output;  ///< empty: standard output
};

void add_manual_options(CLI::App& command, ManualOptions& options);

/// Prints the requested page for the command line `program`. Returns a code of
/// run::ExitCode.
int manual(const CLI::App& program, const ManualOptions& options);

/// A command without subcommands: run, plot, study contacts, ...
struct LeafCommand {
  std::string words;  ///< "study contacts"
  const CLI::App* app;
};
std::vector<LeafCommand> leaf_commands(const CLI::App& program);

}  // namespace blocks::apps
