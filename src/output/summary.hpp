// NAME.summary.json: what scripts want to know of a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/assembly_certificate.hpp"
#include "model/audit_totals.hpp"
#include "model/model.hpp"
#include "output/results.hpp"

namespace blocks::output {

struct RunReport {
  RunIdentity identity;
  std::vector<std::string> warnings;
  double wall_seconds = 0.0;
  std::string status = "done";  ///< done, unsound, interrupted
  long frames = 0;
  SharedCertificate certificate = {};
  std::optional<AuditTotals> audit = {};  ///< nothing: not asked for
};

/// FNV-1a over the bits of all positions and velocities: two equal runs, two equal
/// hashes.
std::string state_hash(const Model& model);

/// Throws FileError.
void write_summary(const std::string& path, const Model& model,
                   const RunReport& report);

}  // namespace blocks::output
