// `blocks run` and `blocks check`: executes the cards of a deck in order. This folder
// connects the deck, the dynamics and the output files.
#pragma once

#include <string>
#include <vector>

#include "model/assembly_certificate.hpp"
#include "model/model.hpp"
#include "run/support/run_options.hpp"

namespace blocks::run {

/// Parses and checks the whole deck, then runs it. Returns an ExitCode.
int run_deck(const RunOptions& options);

/// The model at the first MOTION, CYCLE or SOLVE of a deck, or at its end without them.
struct CheckedDeck {
  ExitCode code = done;  ///< unless `done`, the members below are not valid
  std::string file;      ///< name of the deck in messages
  Model model;
  SharedCertificate certificate;
  double time_step = 0.0;          ///< [T] that a run would take; 0 without blocks
  std::vector<std::string> notes;  ///< on what cards did, one per line
};

/// Parses the deck, builds the model and prints all errors. Makes no step.
CheckedDeck build_checked(const RunOptions& options);

/// Does the same and prints a short report. Returns an ExitCode.
int check_deck(const RunOptions& options);

}  // namespace blocks::run
