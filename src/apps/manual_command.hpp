// `blocks manual`: man pages and bash completion, made from the tables that the program
// itself works by, so that they cannot say anything else.
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

/// Prints what is asked for of the whole command line. Returns an exit code.
int manual(const CLI::App& program, const ManualOptions& options);

/// A command that does something: run, plot, study contacts ...
struct LeafCommand {
  std::string words;  ///< "study contacts"
  const CLI::App* app;
};
std::vector<LeafCommand> leaf_commands(const CLI::App& program);

/// What stands for the value of an option, "FLOAT"; empty for a flag.
std::string value_name(const CLI::Option& option);
/// The words an option is limited to, if it is.
std::vector<std::string> choices(const CLI::Option& option);

}  // namespace blocks::apps
