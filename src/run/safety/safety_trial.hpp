// One trial of a FOS card: the model with reduced strength, run until it is known
// whether it stands (docs/stability.md#a-trial).
#pragma once

#include <functional>
#include <vector>

#include "deck/commands.hpp"
#include "model/model.hpp"
#include "model/safety_factor.hpp"

namespace blocks::run {

/// Whether to give up: asked at each test, by several threads at once.
using GiveUp = std::function<bool()>;

/// Follows the speed of the fastest block during a trial.
class Growth {
 public:
  /// Records the speed at the next test, [L/T].
  void add(double speed) {
    speeds_.push_back(speed);
    sums_.push_back(sums_.back() + speed);
  }
  /// Whether the speed now is at most that at a quarter of the tests so far.
  bool has_slowed_down() const;
  /// Whether the mean speed is at least `factor` times as large in each of three parts
  /// of the tests so far as in the part before: from an eighth to a quarter, to a half,
  /// and to the end. Under a constant force it doubles. A single burst grows once only.
  bool grows_by(double factor) const;

 private:
  double mean(std::size_t begin, std::size_t end) const;

  std::vector<double> speeds_;
  std::vector<double> sums_ = {0.0};  ///< of all speeds before each
};

struct TrialResult {
  SafetyTrial trial;
  Model state;  ///< at the end, with the reduced strength
  bool given_up = false;
};

/// Returns the response of the model: the number of steps in which it forgets a
/// disturbance, at least 50 and at most `max`. All blocks of a copy with a thousand
/// times the strength get the same small velocity; the number is that of the steps in
/// which the root of the kinetic energy falls to a twentieth. It ends earlier if the
/// speed grows steadily, because then the model is not at rest. But blocks that slide
/// swing together, which strong ones do not; so the response is not less than the
/// period of a row of blocks as long as the longest way through the model
/// (dynamics::longest_travel_time). The model must be prepared (dynamics::prepare).
long response_steps(const Model& base, long max, int threads, const GiveUp& give_up);

/// Whether a block is so fast that it could rise by a millionth of its size against the
/// mean acceleration. Then trials do not start from rest.
bool is_moving(const Model& base);

/// Runs a copy of the model with its strength divided by `factor`, and judges it every
/// Solve::test_interval steps:
/// - stable: the forces are balanced as SOLVE wants it, and the fastest block is not
///   faster than at a quarter of the steps;
/// - failing: the motion goes on for 30 responses, so that the speed falls by at most a
///   fifth from part to part (Growth), and a block has moved by a hundredth of its
///   size, the root of its area; or the speed grows by half from part to part, for at
///   least two responses, and a block has moved by a twentieth of its size; or a block
///   has left the domain. Motion with a local ratio below a thousandth of the wanted
///   one is rounding;
/// - undecided: neither after `card.max_steps`, or the model has become unsound.
TrialResult run_trial(const Model& base, double factor, const SafetyFactor& card,
                      const deck::Solve& wanted, int threads, const GiveUp& give_up);

}  // namespace blocks::run
