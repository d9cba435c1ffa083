// Warnings about the motion of the blocks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dynamics/step.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Warns once that a step moved a corner by more than ctol, and once for each block
/// that left the domain.
class MotionWatch {
 public:
  MotionWatch() = default;
  /// For a resumed run. Earlier domain exits count as reported, and a fast corner does
  /// if `fast_told` is true.
  explicit MotionWatch(const Model& model, bool fast_told = false)
      : exits_told_(model.exits.size()), fast_told_(fast_told) {}

  /// Returns the new warnings after a step or, with moved = {}, after
  /// dynamics::prepare().
  std::vector<std::string> after(const Model& model, const dynamics::StepResult& moved);

  bool fast_told() const { return fast_told_; }

 private:
  std::size_t exits_told_ = 0;
  bool fast_told_ = false;
};

}  // namespace blocks::run
