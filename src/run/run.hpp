// `blocks run` and `blocks check`: executes the cards of a deck in order. The only
// place that knows both files and physics.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "deck/parser.hpp"
#include "model/assembly_certificate.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Exit codes of the program (docs/reference: exit codes).
enum ExitCode : int {
  done = 0,
  internal_error = 1,
  usage_error = 2,
  deck_error = 3,
  unsound_run = 4,
  file_error = 5,
  time_limit = 75,
  interrupted = 130
};

struct RunOptions {
  std::string deck;    ///< path, or "-" for standard input
  std::string output;  ///< output name; empty: the deck's stem
  std::optional<std::uint64_t> seed;
  std::optional<std::string> restart;  ///< checkpoint of a RESTART deck
  std::string tape9 = "tape9";
  std::vector<deck::Override> overrides;
  double time_limit = 0.0;          ///< seconds of wall clock, 0: none
  long stop_after = 0;              ///< steps of this run, 0: no limit
  double checkpoint_every = 600.0;  ///< seconds of wall clock
  int threads = 0;                  ///< 0: as many as the machine runs at once
  long audit_every = 0;             ///< steps between audits of the contacts, 0: none
  bool profile = false;             ///< tell where the time went
  bool quiet = false;
  bool verbose = false;
  bool json = false;  ///< the summary on standard output instead of the table
};

/// Parses, checks the whole deck, then runs it. Returns an ExitCode.
int run_deck(const RunOptions& options);

/// What a deck describes before its first step.
struct CheckedDeck {
  ExitCode code = done;  ///< of a deck with faults: theirs, and nothing below counts
  std::string file;      ///< as shown in messages
  Model model;
  SharedCertificate certificate;
  std::vector<std::string> notes;  ///< of mesh files and shared corners, a line each
};

/// Parses and builds everything, prints every fault, makes no step.
CheckedDeck build_checked(const RunOptions& options);

/// The same, and a short report. Returns an ExitCode.
int check_deck(const RunOptions& options);

}  // namespace blocks::run
