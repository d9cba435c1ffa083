// Generates the completion script for bash from the definition of the command line.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace blocks::apps {

/// Returns a script to be sourced; the script never calls the program.
std::string bash_completion(const CLI::App& program);

}  // namespace blocks::apps
