// Tells which blocks have split, and why others have not (docs/cracks.md#the-record).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace blocks::run {

/// What has happened since the last call, one text each.
struct CrackNews {
  std::vector<std::string> cracks;
  std::vector<std::string> warnings;
};

class CrackWatch {
 public:
  CrackWatch() = default;
  /// For a resumed run: what the model records counts as told.
  explicit CrackWatch(const Model& model)
      : reported_cracks_(model.cracks.size()),
        reported_refusals_(model.crack_refusals) {}

  /// Returns the new cracks, and one warning for each new reason of a refusal.
  CrackNews take_news(const Model& model);

 private:
  std::size_t reported_cracks_ = 0;
  std::vector<RefusedCrack> reported_refusals_;
};

/// Returns the closing line: how many blocks have split, and how many have not, by
/// reason.
std::string cracks_line(const Model& model);

}  // namespace blocks::run
