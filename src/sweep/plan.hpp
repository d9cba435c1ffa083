// The plan of a sweep: DIR/sweep.json.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "deck/parser.hpp"
#include "sweep/axes.hpp"
#include "sweep/sobol_design.hpp"

namespace blocks::sweep {

/// What each run does.
enum class Kind {
  run,    ///< runs the deck
  check,  ///< generates, certifies and measures its blocks, without a time step
  study   ///< runs one frame of a scene of `blocks study contacts`
};

struct Plan {
  Kind kind = Kind::run;
  std::string deck;             ///< absolute path; empty for a study
  std::string deck_hash;        ///< FNV-1a of the deck and of the files that it reads
  std::string version;          ///< of the program
  std::string numerics;         ///< see numerics()
  std::string name;             ///< of the files of a run, without extension
  std::optional<double> until;  ///< [T] time of the deck at which runs end
  long audit_every = 0;         ///< steps between audits; 0: none
  std::vector<std::string> variants;  ///< of a study
  std::vector<std::string> axes;      ///< "seed" and the fields, in order
  std::optional<SobolDesign> sobol;   ///< that gives the runs; may be empty
  std::vector<Variation> runs;        ///< the run with id i is runs[i - 1]

  bool operator==(const Plan&) const = default;
};

/// Returns the arithmetic on which the bits of the results depend.
std::string numerics();

/// Returns the path of the plan in the folder of a sweep.
std::string plan_path(const std::string& folder);

/// Returns whether the folder has a plan.
bool has_plan(const std::string& folder);

/// Writes the plan as JSON, one run per line. The folder is created if it is missing.
/// Throws files::FileError.
void write_plan(const std::string& folder, const Plan& plan);

/// Reads the plan of a folder, line by line. Throws files::FileError if there is none,
/// or if it is damaged.
Plan read_plan(const std::string& folder);

/// Describes the first difference between two plans; empty if they are the same.
std::string difference(const Plan& there, const Plan& wanted);

/// Returns the hash of a deck and the files that it reads. Throws files::FileError.
std::string hash_of_deck(const std::string& path);

/// Throws files::FileError if the deck is not that of the plan any more, or if the
/// program has another version or other numerics, so that the runs would not belong
/// together.
void expect_same_program_and_deck(const std::string& folder, const Plan& plan);

/// Returns the --set options of a run, in the form of the deck.
std::vector<deck::Override> overrides_of(const Variation& run);

/// Returns DIR/runs/000/000042 for run 42.
std::string run_folder(const std::string& folder, std::size_t id);

}  // namespace blocks::sweep
