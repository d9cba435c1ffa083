// `blocks run --audit`: selects the steps to audit and collects the findings.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "audit/audit.hpp"
#include "model/audit_totals.hpp"
#include "model/model.hpp"

namespace blocks::run {

class AuditWatch {
 public:
  /// Audits every `every` steps; 0 means never.
  explicit AuditWatch(long every) { totals_.every = every; }

  bool is_due(const Model& model) const {
    return totals_.every > 0 && model.steps % totals_.every == 0;
  }
  /// Keeps a copy of the blocks and of what the laws of joints hold, from which the
  /// next step decides its contacts. The list of contacts must be up to date.
  void keep_start(const Model& model);

  struct Verdict {
    std::vector<std::string> faults;    ///< missed pairs and wrong decisions: unsound
    std::vector<std::string> stories;   ///< details of the blocks named in the faults
    std::vector<std::string> overlaps;  ///< excess overlaps not reported before
    std::vector<std::string> deep;      ///< contacts too deep, not reported before
  };
  /// Audits the step that was just made. `listed` holds the pairs that it used.
  Verdict audit_step(const Model& model, std::vector<std::pair<int, int>> listed);

  const AuditTotals& totals() const { return totals_; }
  /// A summary in one line: "audit every 100 steps: 12 moments, ... wrong decisions: 0;
  /// ...".
  std::string summary() const;

 private:
  void count(const audit::Findings& found);
  void keep_worst(const audit::Findings& found, long step, double time);
  /// Adds wrong decisions and missed pairs. `order`: that of the model.
  void add_faults(const audit::Findings& found, const std::vector<int>& order,
                  Verdict& verdict) const;

  Blocks blocks_;
  std::vector<audit::HeldContact> held_;
  double left_ = 0.0;  ///< [L] distance corners may move before the next search
  AuditTotals totals_;
  std::map<std::pair<int, int>, std::size_t> reported_;  ///< index into totals_.excess
  std::map<std::pair<int, int>, std::size_t>
      reported_deep_;  ///< index into totals_.deep
};

}  // namespace blocks::run
