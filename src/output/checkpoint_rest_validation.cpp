#include "output/checkpoint_rest_validation.hpp"

#include "output/checkpoint_expectations.hpp"

namespace blocks::output {

using namespace expectations;

void expect_equilibria(const Model& model) {
  for (const SolveRecord& solve : model.solves) {
    for (const double value :
         {static_cast<double>(solve.line), solve.wanted, solve.reached,
          static_cast<double>(solve.steps), solve.time, solve.largest,
          solve.wanted_local, solve.reached_local, solve.dt, solve.least_scale,
          solve.largest_scale})
      expect("solves", value, not_negative);
    for (const int block : {solve.block, solve.local_block})
      expect_index("solves/block", block + 1, model.blocks.size() + 1);
  }
  for (const SafetyFactor& card : model.safety_factors)
    for (const double value :
         {static_cast<double>(card.line), card.width, card.lower, card.upper,
          static_cast<double>(card.response), static_cast<double>(card.most_steps)})
      expect("safety_factors", value, not_negative);
  for (const SafetyTrial& trial : model.safety_trials) {
    expect_index("safety_trials/search", trial.search,
                 static_cast<int>(model.safety_factors.size()));
    expect_index("safety_trials/outcome", static_cast<int>(trial.outcome),
                 trial_outcomes);
    expect_index("safety_trials/block", trial.block + 1, model.blocks.size() + 1);
    for (const double value : {trial.factor, static_cast<double>(trial.steps),
                               trial.ratio, trial.local, trial.speed, trial.moved})
      expect("safety_trials", value, not_negative);
  }
}

}  // namespace blocks::output
