// Completion for bash, from the command line's own definition.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace blocks::apps {

/// A script to be sourced; it asks the program for nothing.
std::string bash_completion(const CLI::App& program);

}  // namespace blocks::apps
