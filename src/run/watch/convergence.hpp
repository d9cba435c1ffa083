// Decides when the steps of a SOLVE card have reached equilibrium (docs/rest.md#solve).
#pragma once

#include <limits>
#include <string>

#include "deck/commands.hpp"
#include "model/local_ratio.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Follows the unbalanced ratio (model/equilibrium.hpp) and the largest local ratio
/// (model/local_ratio.hpp) during one SOLVE card. They are tested after every
/// Solve::test_interval-th step of the card and after its last one. The forces are
/// balanced when two successive tests find at most the ratios of the card, because a
/// block that swings passes its position of rest. While gravity or a load still
/// changes, they are not.
class Convergence {
 public:
  /// Starts a card. If a restart continues it, `made` is the number of its steps before
  /// the restart, and `was_below` the value of is_below() at that moment.
  explicit Convergence(const deck::Solve& card, long made = 0, bool was_below = false);

  /// Whether the model must be read after the next step, because it will be tested.
  bool is_due() const;
  /// Counts a step. If a test was due, the model must be up to date.
  void after_step(const Model& model);

  bool is_balanced() const { return balanced_; }
  /// Whether the card needs no more steps: balanced, or all steps made.
  bool is_finished() const { return balanced_ || made_ >= max_; }
  /// Whether the last test found at most the ratios of the card.
  bool is_below() const { return below_; }
  /// What the last test found; NaN if none was made.
  const Balance& balance() const { return now_; }
  /// Whether the last test has found the ratio in a lower decade than all tests before
  /// it.
  bool has_new_decade() const { return new_decade_; }
  /// Estimates the completed share of the card, 0 to 1, from the logarithms of both
  /// ratios. It never decreases.
  double share() const { return share_; }
  /// The result of the card, once it is finished. `line` is that of the card.
  SolveRecord record(const Model& model, int line) const;

 private:
  double wanted_, wanted_local_;
  long max_, made_;
  bool below_, balanced_ = false, new_decade_ = false;
  Balance now_;                                              ///< of the last test
  Balance first_;                                            ///< of the first test
  double decade_ = std::numeric_limits<double>::infinity();  ///< floor(log10(ratio))
  double share_ = 0.0;
};

/// Returns the line that the console shows as the result of a SOLVE card.
std::string solve_line(const SolveRecord& solve);
/// Returns the warning about a card that has not converged. It has both ratios, the
/// blocks with the largest unbalanced force and the largest local ratio, and what may
/// help.
std::string solve_warning(const SolveRecord& solve, const Settings& settings);

}  // namespace blocks::run
