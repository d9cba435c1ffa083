// The options of a run, and the exit codes of the program.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "deck/parser.hpp"
#include "model/assembly_certificate.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Exit codes of the program, as listed in docs/README.md.
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
  std::string deck;  ///< path, or "-" for standard input
  /// The deck itself. `deck` is then its name, and names of files on its cards are
  /// relative to the current directory.
  std::optional<std::string> text;
  std::string output;  ///< output name; if empty, the deck's stem
  std::optional<std::uint64_t> seed;
  std::optional<std::string> restart;  ///< checkpoint of a RESTART deck
  std::string tape9 = "tape9";
  std::vector<deck::Override> overrides;
  std::string last_card;            ///< added behind the last card; may be empty
  std::string last_card_options;    ///< of blocks fos, which give that card
  std::optional<double> until;      ///< [T] > 0, time of the deck at which the run ends
  double time_limit = 0.0;          ///< wall-clock seconds; 0 means no limit
  long stop_after = 0;              ///< steps of this run; 0 means no limit
  double checkpoint_every = 600.0;  ///< wall-clock seconds
  int threads = 0;                  ///< 0 means as many as the machine has
  int trials_at_once = 0;           ///< of FOS; 0: as many as threads
  long audit_every = 0;             ///< steps between audits; 0 means none
  bool profile = false;             ///< print where the time went
  bool driven = false;              ///< a program makes the steps: no MOTION is needed
  /// An interrupt before the run ends the process at once.
  bool ends_process = false;
  bool quiet = false;
  bool verbose = false;
  bool json = false;  ///< print the summary instead of the table
  /// Receives the blocks and their certificate when a new run begins: the model at the
  /// first MOTION, CYCLE or SOLVE, or at the end of a deck without them. Not called by
  /// a run that continues.
  std::function<void(const Model&, const SharedCertificate&)> at_start;
  /// Receives the messages about the deck, which are printed otherwise.
  std::function<void(const deck::Diagnostics&)> tell;
  /// Receives the warnings of the run, which are printed otherwise.
  std::function<void(const std::string&)> warn;
};

}  // namespace blocks::run
