// What a run has to be warned of as blocks move.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dynamics/step.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Tells once that a step moved a corner by more than ctol, and of every block that
/// left the domain.
class MotionWatch {
 public:
  MotionWatch() = default;
  /// A run that goes on: exits of before were told of, and a fast corner if fast_told.
  explicit MotionWatch(const Model& model, bool fast_told = false)
      : exits_told_(model.exits.size()), fast_told_(fast_told) {}

  /// What is new after a step (or, with moved = {}, after a boxing) of the model.
  std::vector<std::string> after(const Model& model,
                                 const dynamics::StepResult& moved);

  bool fast_told() const { return fast_told_; }

 private:
  std::size_t exits_told_ = 0;
  bool fast_told_ = false;
};

}  // namespace blocks::run
