// Steps a model, inside in the order of its own that it may have (Model::order);
// outside nobody meets other numbers than the deck's.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "dynamics/step.hpp"
#include "model/numbering.hpp"

namespace blocks::dynamics {

/// Where the model has no order, this is advance() and catch_up(). Else a second model,
/// in that order, is stepped, and stays as it is whoever reads in between.
class Stepper {
 public:
  Stepper(Model& model, Workspace& work) : model_(model), work_(work) {}

  /// The model has been changed from outside, when it was up to date.
  void changed() {
    inside_current_ = false;
    work_.springs.list_changed();
  }
  /// dynamics::advance. Of the model time, steps, search, worst overlap and exits are
  /// those after it, all else stays behind.
  StepResult advance(bool readings,
                     double alarm = std::numeric_limits<double>::infinity());
  /// The model as it stands after the last step.
  const Model& up_to_date();
  /// The near pairs of blocks that the last step used, low < high, in the deck's
  /// numbers and in ascending order. At least one step has been made.
  std::vector<std::pair<int, int>> listed_pairs() const;

 private:
  void bring_in();
  void bring_out();
  void bring_out_time();

  Model& model_;  ///< in the deck's numbers
  Workspace& work_;
  Model inside_;
  Numbering inwards_, outwards_;
  bool inside_current_ = false;  ///< not older than the model
  bool outside_current_ = true;  ///< the other way round
};

}  // namespace blocks::dynamics
