// Warnings about the motion of the blocks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dynamics/step.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// The warnings of a MotionWatch that are given once.
struct ReportedWarnings {
  bool fast = false, flight = false, deep = false;
};

/// Warns once that a step moved a corner by more than ctol, once that a block flies
/// while LOCDAMP acts, once that no overlap explains the depth of a contact, and once
/// for each block that left the domain.
class MotionWatch {
 public:
  MotionWatch() = default;
  /// For a resumed run. Earlier domain exits count as reported.
  explicit MotionWatch(const Model& model, const ReportedWarnings& reported = {})
      : reported_exits_(model.exits.size()), reported_(reported) {}

  /// Returns the new warnings after a step or, with moved = {}, after
  /// dynamics::prepare().
  std::vector<std::string> check_step(const Model& model,
                                      const dynamics::StepResult& moved);

  /// Whether check_state() is to be called after the step that the model has made. This
  /// depends on the model alone, so that a resumed run gives the same warnings.
  bool is_state_check_due(const Model& model) const;
  /// Returns the warnings about the first block that touches nothing and has the speed
  /// of a fall by more than ctol, and about the deepest contact that no overlap
  /// explains (find_deep_contact). The model must have been read.
  std::vector<std::string> check_state(const Model& model);

  const ReportedWarnings& reported() const { return reported_; }

 private:
  bool has_flights(const Model& model) const;

  std::size_t reported_exits_ = 0;
  ReportedWarnings reported_;
};

}  // namespace blocks::run
