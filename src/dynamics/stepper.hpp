// Steps a model whose blocks may be renumbered internally (Model::order). Callers see
// the deck's numbers only.
#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "dynamics/step.hpp"
#include "model/numbering.hpp"

namespace blocks::dynamics {

/// If the model has no order, steps it. Otherwise a second model with the blocks in
/// that order is stepped. Reading the first model between steps does not affect the
/// second one.
class Stepper {
 public:
  Stepper(Model& model, Workspace& work) : model_(model), work_(work) {}

  /// To be called after the model has been changed from outside. The model must have
  /// been up to date before the change. If blocks have changed, Model::kept must be
  /// emptied too, as prepare() does.
  void changed() {
    inside_current_ = false;
    work_.springs.list_changed();
  }
  /// To be called after velocities, spins or loads have been changed from outside. The
  /// model must have been up to date before the change. As after a card, the next step
  /// makes all decisions again that are kept although they may change.
  void take_velocities_and_loads();
  /// Calls dynamics::advance. If the model has an order, only its time, steps, search,
  /// worst overlap, exits, energy, drives and servos are updated. The rest is out of
  /// date until up_to_date().
  StepResult advance(bool readings,
                     double alarm = std::numeric_limits<double>::infinity());
  /// Splits the blocks whose strength the last step has reached
  /// (dynamics::crack_blocks). Returns the number of cracks; if there are any, the
  /// model is up to date.
  int crack();
  /// Called before the blocks of the model are replaced by pieces; may be empty.
  std::function<void()> before_split;
  /// Brings the model up to the last step and returns it.
  const Model& up_to_date();
  /// Brings the model up to the last step, with the decisions that a checkpoint needs
  /// to go on with the same bits (Model::kept), and returns it.
  const Model& complete();
  /// Brings the blocks of the model up to the last step. Without an order they always
  /// are, so that the list of contacts need not be written.
  void bring_out_blocks() {
    if (!outside_current_)
      up_to_date();
  }
  /// Returns the near pairs of blocks that the last step used, low < high, in the
  /// deck's numbers and in ascending order. At least one step must have been made.
  std::vector<std::pair<int, int>> listed_pairs() const;

 private:
  /// Copies model_ to inside_, in the order of the steps.
  void bring_in();
  /// Copies blocks and contacts of inside_ back to model_.
  void bring_out();
  /// Gives blocks that have split inside their places in the order, and renumbers.
  void adopt_pieces();
  /// Copies time, steps, search, worst overlap and exits back to model_.
  void bring_out_time();

  Model& model_;  ///< in the deck's numbers
  Workspace& work_;
  Model inside_;
  Numbering inwards_, outwards_;
  bool inside_current_ = false;  ///< inside_ includes the latest change of model_
  bool outside_current_ = true;  ///< model_ includes the latest step of inside_
};

}  // namespace blocks::dynamics
