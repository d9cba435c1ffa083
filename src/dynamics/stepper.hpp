// Steps a model, inside in the order of its own that it may have (Model::order);
// outside nobody meets other numbers than the deck's.
#pragma once

#include <limits>

#include "dynamics/step.hpp"
#include "model/numbering.hpp"

namespace blocks::dynamics {

/// Where the model has no order, this is advance() and catch_up(). Else a second model,
/// in that order, is stepped, and stays as it is whoever reads in between.
class Stepper {
 public:
  Stepper(Model& model, SearchBuffers& buffers) : model_(model), buffers_(buffers) {}

  /// The model has been changed from outside, when it was up to date.
  void changed() {
    inside_current_ = false;
    buffers_.outdated_at = -1;
  }
  /// dynamics::advance. Of the model time, steps, search, worst overlap and exits are
  /// those after it, all else stays behind.
  Displacement advance(bool readings,
                       double alarm = std::numeric_limits<double>::infinity());
  /// The model as it stands after the last step.
  const Model& up_to_date();

 private:
  void bring_in();
  void bring_out();
  void bring_out_time();

  Model& model_;  ///< in the deck's numbers
  SearchBuffers& buffers_;
  Model inside_;
  Numbering inwards_, outwards_;
  std::vector<int> record_outside_;  ///< of each record inside
  long listed_ = -1;                 ///< NUPDAT of the list they are of
  bool inside_current_ = false;      ///< not older than the model
  bool outside_current_ = true;      ///< the other way round
};

}  // namespace blocks::dynamics
