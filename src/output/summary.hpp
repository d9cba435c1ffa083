// NAME.summary.json: the summary of a run, for scripts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/assembly_certificate.hpp"
#include "model/audit_totals.hpp"
#include "model/model.hpp"
#include "output/results/results.hpp"

namespace blocks::output {

struct RunReport {
  RunIdentity identity;
  std::vector<std::string> warnings;
  double wall_seconds = 0.0;
  /// One of "done", "deck error", "unsound", "time limit", "step limit", "interrupted".
  std::string status = "done";
  long frames = 0;
  SharedCertificate certificate = {};
  std::optional<AuditTotals> audit = {};  ///< empty if not requested
  /// Whether all SOLVE cards of the deck have been carried out; empty if it has none.
  std::optional<bool> solved = {};
};

/// FNV-1a over the bits of all positions and velocities. Identical runs have identical
/// hashes.
std::string state_hash(const Model& model);

/// Writes the summary. Throws FileError.
void write_summary(const std::string& path, const Model& model,
                   const RunReport& report);

}  // namespace blocks::output
