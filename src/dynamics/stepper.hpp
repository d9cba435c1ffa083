// Steps a model whose blocks may be renumbered in the meantime (Model::order). Callers
// see the deck's numbers only.
#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "dynamics/step.hpp"
#include "model/numbering.hpp"

namespace blocks::dynamics {

/// Steps a model. While the steps are made, the blocks of a model with an order are in
/// that order.
class Stepper {
 public:
  Stepper(Model& model, Workspace& work) : model_(model), work_(work) {}

  /// To be called after the model has been changed from outside. The model must have
  /// been up to date before the change. If blocks have changed, Model::kept must be
  /// emptied too, as prepare() does. Throws std::logic_error if the model is still in
  /// the order of the steps.
  void changed();
  /// To be called after velocities, spins or loads have been changed from outside. The
  /// model must have been up to date before the change. As after a card, the next step
  /// makes all decisions again that are kept although they may change.
  void take_velocities_and_loads() {
    work_.decisions.expire_exact();
    model_.kept = {};
  }
  /// Calls dynamics::advance. Blocks, contacts with blocks and planes, loads, drives
  /// and servos of the model must not be read or changed before up_to_date().
  StepResult advance(bool readings,
                     double alarm = std::numeric_limits<double>::infinity());
  /// Splits the blocks whose strength the last step has reached
  /// (dynamics::crack_blocks). Returns the number of cracks; if there are any, the
  /// model is up to date.
  int crack();
  /// Called before the blocks of the model are replaced by pieces; may be empty.
  std::function<void()> before_split;
  /// Brings the model up to the last step, in the deck's numbers, and returns it.
  const Model& up_to_date();
  /// Brings the model up to the last step, with the decisions that a checkpoint needs
  /// to go on with the same bits (Model::kept), and returns it.
  const Model& complete();
  /// Brings the blocks of the model up to the last step. Without an order they always
  /// are, so that the list of contacts need not be written.
  void bring_out_blocks() {
    if (is_in_order_)
      up_to_date();
  }
  /// Returns the near pairs of blocks that the last step used, low < high, in the
  /// deck's numbers and in ascending order. At least one step must have been made.
  std::vector<std::pair<int, int>> listed_pairs() const;

 private:
  /// Puts the blocks into the order, if the model has one.
  void enter_order();
  /// Gives the blocks the deck's numbers.
  void leave_order();
  /// Gives new pieces places at the end of the order.
  void extend_order();

  Model& model_;
  Workspace& work_;
  Numbering inwards_;  ///< from the deck's numbers to the order; empty: not known
  bool is_in_order_ = false;
};

}  // namespace blocks::dynamics
