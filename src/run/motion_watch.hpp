// Warnings about the motion of the blocks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dynamics/step.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Warns once that a step moved a corner by more than ctol, once that a block flies
/// while LOCDAMP acts, and once for each block that left the domain.
class MotionWatch {
 public:
  MotionWatch() = default;
  /// For a resumed run. Earlier domain exits count as reported, and a fast corner or a
  /// flight does if `fast_told` or `flight_told` is true.
  explicit MotionWatch(const Model& model, bool fast_told = false,
                       bool flight_told = false)
      : exits_told_(model.exits.size()), fast_told_(fast_told),
        flight_told_(flight_told) {}

  /// Returns the new warnings after a step or, with moved = {}, after
  /// dynamics::prepare().
  std::vector<std::string> after(const Model& model, const dynamics::StepResult& moved);

  /// Whether flight() is to be called after the step that the model has made. This
  /// depends on the model alone, so that a resumed run gives the same warning.
  bool is_flight_due(const Model& model) const;
  /// Returns the warning about the first block that touches nothing and has the speed
  /// of a fall by more than ctol; empty if there is none. The model must have been
  /// read.
  std::string flight(const Model& model);

  bool fast_told() const { return fast_told_; }
  bool flight_told() const { return flight_told_; }

 private:
  std::size_t exits_told_ = 0;
  bool fast_told_ = false, flight_told_ = false;
};

}  // namespace blocks::run
