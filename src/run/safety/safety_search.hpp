// Runs the trials of a FOS card, several at once (docs/stability.md#several-at-once).
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "run/safety/safety_trial.hpp"

namespace blocks::run {

/// Returns the record of a FOS card. Its limits of steps are not known yet.
SafetyFactor begin_search(const deck::Fos& card, int line);

/// Sets the response of the model and the largest number of steps of a trial. Returns
/// false, and sets nothing, if it gave up.
bool set_limits(SafetyFactor& record, const Model& base, const deck::Fos& card,
                int threads, const GiveUp& give_up);

/// Adds a trial of the last card to the records of the model.
void record_trial(Model& model, SafetyTrial trial);

/// Returns the trials of the last card in Model::safety_factors.
std::vector<SafetyTrial> trials_of_last(const Model& model);

/// Removes the records of the last card and of its trials.
void forget_last_search(Model& model);

/// Returns the model without the records of its last FOS card: the state from which its
/// trials start.
Model state_before_last(const Model& model);

class SafetySearch {
 public:
  /// Trials start from `base`, which must be prepared (dynamics::prepare) and outlive
  /// the search. `at_once` trials run side by side, each with threads / at_once
  /// threads, but at least one.
  SafetySearch(const Model& base, const SafetyFactor& card, const deck::Solve& wanted,
               int threads, int at_once, GiveUp give_up);
  /// Gives up the trials that still run.
  ~SafetySearch();
  SafetySearch(const SafetySearch&) = delete;
  SafetySearch& operator=(const SafetySearch&) = delete;

  /// Returns the result of the next trial after those in `trials`; empty if none is
  /// needed. Meanwhile others run that may be needed later, so that the results and
  /// their order do not depend on `at_once`. `idle` is called now and then while the
  /// caller waits; what it throws ends the search.
  std::optional<TrialResult> next(std::span<const SafetyTrial> trials,
                                  const std::function<void()>& idle = {});

 private:
  struct Running {
    std::shared_ptr<std::atomic<bool>> unneeded;
    std::future<TrialResult> result;
  };
  void start(double factor);

  const Model& base_;
  SafetyFactor card_;
  deck::Solve wanted_;
  int threads_;  ///< of one trial
  std::size_t at_once_;
  GiveUp give_up_;
  std::map<double, Running> running_;  ///< by factor
};

}  // namespace blocks::run
