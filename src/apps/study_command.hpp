// `blocks study`: the command line of the studies of contact detection.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace blocks::apps {

struct StudyOptions {
  std::vector<std::string> scenes;    ///< names, "all" or decks
  std::vector<std::string> variants;  ///< names; empty: all
  std::optional<std::string>
      expected;  ///< variant that gives the expected motion of a deck; empty: default
  int frames = 20, first = 0, threads = 1;
  long steps = 0;  ///< 0: the scene's own
  std::uint64_t seed = 1982;
  std::optional<double> offset, scale;
  std::string csv, json, figure, deck;
  bool list = false, gate = false;
};

void add_study_options(CLI::App& command, StudyOptions& options);

/// Runs the study. Returns a code of run::ExitCode.
int study_contacts(const StudyOptions& options);

}  // namespace blocks::apps
