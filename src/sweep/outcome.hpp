// How a run of a sweep ended: outcome.json in its folder, the last file that it writes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace blocks::sweep {

struct Outcome {
  int code = 0;         ///< exit code of the run; 128 + signal if it crashed
  std::string status;   ///< "done", "deck error", "unsound", "time limit", ...
  std::string message;  ///< the first error; empty if there was none
  /// What was measured: "layers" (layer_measures.hpp), "study" (study_outcome.hpp),
  /// "factor_of_safety" (safety_outcome()).
  nlohmann::ordered_json measured = nlohmann::ordered_json::object();
};

/// Returns the status that belongs to an exit code.
std::string status_of(int code);

/// Whether a run that ended with this code is finished for good. One that was
/// interrupted, or that could not write its files, goes on.
bool is_final(int code);

/// Returns the outcome in the folder of a run, or nothing if there is none, so that the
/// run is missing, at work, or stopped. An empty file, which a crash of the machine can
/// leave, is none. Throws files::FileError if it is damaged.
std::optional<Outcome> read_outcome(const std::string& run_folder);

/// The status of an outcome that cannot be read.
inline constexpr const char* damaged_outcome = "damaged outcome";

/// Returns the outcome in the folder of a run, or nothing if there is none. If it is
/// damaged, returns one with the status damaged_outcome and a message that says what to
/// do.
std::optional<Outcome> read_outcome_or_damage(const std::string& run_folder);

/// Returns whether there is one, without reading it.
bool has_outcome(const std::string& run_folder);

/// Writes it, all at once. Throws files::FileError.
void write_outcome(const std::string& run_folder, const Outcome& outcome);

/// Removes it, so that the run goes on. Throws files::FileError.
void remove_outcome(const std::string& run_folder);

/// Returns {"lower": 1.39, "upper": 1.4} of the summary of a run (NAME.summary.json);
/// an end that no trial proved is null. Returns null if the deck has no FOS card.
nlohmann::ordered_json safety_outcome(const nlohmann::ordered_json& summary);

}  // namespace blocks::sweep
