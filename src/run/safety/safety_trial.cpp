#include "run/safety/safety_trial.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/cracks/cracking.hpp"
#include "dynamics/preparation/mass_scaling.hpp"
#include "dynamics/preparation/travel_time.hpp"
#include "dynamics/stepper.hpp"
#include "run/watch/convergence.hpp"
#include "run/watch/soundness.hpp"

namespace blocks::run {
namespace {

constexpr long interval = deck::Solve::test_interval;

/// A copy of a model with other strength, and what steps it.
class Copy {
 public:
  Copy(const Model& base, double factor, int threads)
      : model_(base), work_(threads), stepper_(model_, work_) {
    reduce_strength(model_.settings, factor);
    model_.kept = {};
    model_.search.invalidate();
    if (dynamics::may_scale_masses(model_))
      dynamics::begin_mass_scaling(model_);
    half_depth_ = half_depth(model_.blocks);
  }

  Model& model() { return model_; }
  const Model& now() { return stepper_.up_to_date(); }
  /// Makes `steps` steps. Returns false if the model is unsound.
  bool make(long steps) {
    const double limit = model_.settings.normal_stiffness * half_depth_;
    for (long i = 1; i <= steps; ++i) {
      const dynamics::StepResult moved = stepper_.advance(i == steps, limit);
      if (may_be_unsound(model_.settings, moved, half_depth_) &&
          !unsound(stepper_.up_to_date(), moved, half_depth_).empty())
        return false;
      if (dynamics::may_crack(model_.settings) && stepper_.crack() > 0)
        half_depth_ = half_depth(model_.blocks);
    }
    return true;
  }
  Model take() {
    stepper_.complete();
    model_.kept = {};
    dynamics::end_mass_scaling(model_);
    return std::move(model_);
  }

 private:
  Model model_;
  dynamics::Workspace work_;
  dynamics::Stepper stepper_;
  double half_depth_ = 0.0;
};

/// Returns the speed of a block, its spin counted at the radius of gyration, [L/T].
double speed_of(const Blocks& blocks, int b) {
  return std::hypot(blocks.velocity.col(b).norm(),
                    std::sqrt(blocks.inertia[b] / blocks.mass[b]) * blocks.spin[b]);
}

void find_fastest(const Blocks& blocks, SafetyTrial& trial) {
  trial.speed = 0.0, trial.block = -1;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      if (const double speed = speed_of(blocks, b);
          trial.block < 0 || speed > trial.speed)
        trial.speed = speed, trial.block = b;
}

/// The largest distance that a centroid has moved.
struct Distance {
  double length = 0.0;   ///< [L]
  double of_size = 0.0;  ///< the largest one over the root of the area of the block
};

/// Pieces of blocks that have split do not count.
Distance farthest(const Blocks& before, const Blocks& after) {
  Distance max;
  for (int b = 0; b < before.size(); ++b) {
    if (!after.is_free(b))
      continue;
    const double moved = (after.centroid.col(b) - before.centroid.col(b)).norm();
    max.length = std::max(max.length, moved);
    max.of_size = std::max(max.of_size, moved / std::sqrt(before.area[b]));
  }
  return max;
}

/// Returns whether the motion is that of a failing model. `responses` is the number of
/// steps so far over the response of the model.
bool is_failing(double responses, const Growth& growth, const Distance& moved) {
  constexpr double many = 30.0, notable = 0.01, few = 2.0, far = 0.05;
  constexpr double goes_on = 0.8, grows = 1.5;
  return (responses >= many && moved.of_size > notable && growth.grows_by(goes_on)) ||
         (responses >= few && moved.of_size > far && growth.grows_by(grows));
}

double kinetic_energy(const Blocks& blocks) {
  double sum = 0.0;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      sum += 0.5 * blocks.mass[b] * std::pow(speed_of(blocks, b), 2);
  return sum;
}

/// Returns the mean acceleration that the forces on free blocks would give them if they
/// were not balanced, [L/T^2].
double usual_acceleration(const Model& model) {
  double mass = 0.0, force = 0.0;
  for (int b = 0; b < model.blocks.size(); ++b)
    if (model.blocks.is_free(b))
      mass += model.blocks.mass[b];
  for (const Contact& contact : model.contacts)
    force += std::abs(contact.normal_force);
  return mass > 0.0 ? model.settings.gravity.norm() + force / mass : 0.0;
}

/// Gives all free blocks the same small velocity, so that the slowest modes have most
/// of its energy. Its direction is between that of gravity, or -y without gravity, and
/// the direction across it.
void disturb(Model& model) {
  constexpr double small = 1e-3;
  const Vec2 gravity = model.settings.gravity;
  const Vec2 down = gravity.norm() > 0.0 ? Vec2(gravity.normalized()) : Vec2(0.0, -1.0);
  const Vec2 slanted = (down + Vec2(-down.y(), down.x())).normalized();
  const double speed = small * usual_acceleration(model) * model.time_step.dt;
  for (int b = 0; b < model.blocks.size(); ++b)
    if (model.blocks.is_free(b))
      model.blocks.velocity.col(b) = speed * slanted;
}

}  // namespace

bool Growth::has_slowed_down() const {
  return !speeds_.empty() && speeds_.back() <= speeds_[(speeds_.size() - 1) / 4];
}

double Growth::mean(std::size_t begin, std::size_t end) const {
  return (sums_[end] - sums_[begin]) / static_cast<double>(end - begin);
}

bool Growth::grows_by(double factor) const {
  const std::size_t n = speeds_.size();
  if (n < 8)
    return false;
  const double early = mean(n / 8, n / 4), later = mean(n / 4, n / 2),
               late = mean(n / 2, n);
  return later >= factor * early && late >= factor * later;
}

bool is_moving(const Model& base) {
  constexpr double small = 1e-6;
  const double acceleration = usual_acceleration(base);
  for (int b = 0; b < base.blocks.size(); ++b)
    if (base.blocks.is_free(b) &&
        0.5 * std::pow(speed_of(base.blocks, b), 2) >
            small * acceleration * std::sqrt(base.blocks.area[b]))
      return true;
  return false;
}

long response_steps(const Model& base, long max, int threads, const GiveUp& give_up) {
  constexpr double reduction = 1e-3, part = 0.05;
  constexpr long fewest = 50;
  Copy copy(base, reduction, threads);
  const double period = 4.0 * dynamics::longest_travel_time(copy.model());
  disturb(copy.model());
  const double forgotten = part * part * kinetic_energy(copy.model().blocks);
  Growth growth;
  long steps = 0;
  for (bool ends = false, below = false; !ends && steps < max && !give_up();) {
    ends = !copy.make(interval);
    steps += interval;
    const double energy = kinetic_energy(copy.now().blocks);
    growth.add(std::sqrt(energy));
    ends = ends || (below && energy <= forgotten) || growth.grows_by(1.5);
    below = energy <= forgotten;
  }
  const auto swing = static_cast<long>(std::ceil(period / copy.now().time_step.dt));
  return std::min(std::max({steps, swing, fewest}), max);
}

TrialResult run_trial(const Model& base, double factor, const SafetyFactor& card,
                      const deck::Solve& wanted, int threads, const GiveUp& give_up) {
  constexpr double rounding = 1e-3;
  TrialResult result{.trial = {.factor = factor}, .state = {}};
  SafetyTrial& trial = result.trial;
  Copy copy(base, factor, threads);
  Convergence convergence(wanted);
  Growth growth;
  bool decided = false;
  while (!decided && trial.steps < card.max_steps && !result.given_up) {
    const long steps = std::min(interval, card.max_steps - trial.steps);
    const bool sound = copy.make(steps);
    trial.steps += steps;
    const Model& now = copy.now();
    for (long i = 0; i < steps; ++i)
      convergence.after_step(now);
    find_fastest(now.blocks, trial);
    growth.add(trial.speed);
    const double responses =
        static_cast<double>(trial.steps) / static_cast<double>(card.response);
    if (now.exits.size() > base.exits.size())
      trial.outcome = TrialOutcome::failing, decided = true;
    else if (convergence.is_balanced() && growth.has_slowed_down())
      trial.outcome = TrialOutcome::stable, decided = true;
    else if (sound && convergence.balance().local > rounding * wanted.local_ratio() &&
             is_failing(responses, growth, farthest(base.blocks, now.blocks)))
      trial.outcome = TrialOutcome::failing, decided = true;
    decided = decided || !sound;
    result.given_up = !decided && give_up();
  }
  trial.ratio = convergence.balance().ratio;
  trial.local = convergence.balance().local;
  result.state = copy.take();
  trial.moved = farthest(base.blocks, result.state.blocks).length;
  return result;
}

}  // namespace blocks::run
