// Generates the man page blocks(1) from the definition of the command line.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace blocks::apps {

std::string program_manual(const CLI::App& program);

}  // namespace blocks::apps
