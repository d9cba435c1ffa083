// `blocks run --audit`: which steps are audited, and what is kept of the findings.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/audit_totals.hpp"
#include "model/model.hpp"

namespace blocks::run {

class AuditWatch {
 public:
  /// Every so many steps; 0: never.
  explicit AuditWatch(long every) { totals_.every = every; }

  bool due(const Model& model) const {
    return totals_.every > 0 && model.steps % totals_.every == 0;
  }
  /// Keeps the blocks from which the next step decides its contacts.
  void before(const Model& model);

  struct Verdict {
    std::vector<std::string> faults;    ///< missed pairs, wrong decisions: unsound
    std::vector<std::string> stories;   ///< of the blocks they name
    std::vector<std::string> overlaps;  ///< pairs in excess not told before
    std::vector<std::string> deep;      ///< contacts too deep, not told before
  };
  /// Judges the step just made. `listed` has the pairs that it used.
  Verdict after(const Model& model, std::vector<std::pair<int, int>> listed);

  const AuditTotals& totals() const { return totals_; }
  /// One line: "audit every 100 steps: 12 moments, ... wrong decisions: 0; ...".
  std::string closing() const;

 private:
  Blocks blocks_;
  double left_ = 0.0;  ///< [L] how far corners may go before the next list
  AuditTotals totals_;
  std::map<std::pair<int, int>, std::size_t> told_;       ///< where in totals_.excess
  std::map<std::pair<int, int>, std::size_t> told_deep_;  ///< where in totals_.deep
};

}  // namespace blocks::run
