#include "run/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/counted.hpp"
#include "model/equilibrium.hpp"

namespace blocks::run {

Convergence::Convergence(const deck::Solve& card, long made, bool was_below)
    : wanted_(card.ratio.value), most_(card.nmax.value), made_(made),
      below_(was_below) {}

bool Convergence::is_due() const {
  const long next = made_ + 1;
  return next % deck::Solve::test_interval == 0 || next == most_;
}

void Convergence::after_step(const Model& model) {
  const bool tested = is_due();
  ++made_;
  new_decade_ = false;
  share_ = std::max(share_, static_cast<double>(made_) / static_cast<double>(most_));
  if (!tested)
    return;
  ratio_ = unbalanced_ratio(model);
  const bool is_below = ratio_ <= wanted_ && !loads_will_change(model);
  // Two tests that are too near each other may both see a block that passes F = 0.
  balanced_ = below_ && is_below && made_ % deck::Solve::test_interval == 0;
  below_ = is_below;
  if (const double decade = std::floor(std::log10(ratio_)); decade < decade_)
    decade_ = decade, new_decade_ = true;
  if (first_ratio_ == 0.0)
    first_ratio_ = ratio_;
  if (first_ratio_ > wanted_ && ratio_ > wanted_)
    share_ = std::max(share_, std::log(first_ratio_ / ratio_) /
                                  std::log(first_ratio_ / wanted_));
  else if (ratio_ <= wanted_)
    share_ = 1.0;
}

SolveRecord Convergence::record(const Model& model, int line) const {
  SolveRecord solve;
  solve.line = line;
  solve.wanted = wanted_;
  solve.reached = ratio_;
  solve.steps = made_;
  solve.time = model.time;
  solve.converged = balanced_;
  for (int b = 0; b < model.blocks.size(); ++b)
    if (const double force = unbalanced_force(model, b); force > solve.largest)
      solve.largest = force, solve.block = b;
  return solve;
}

std::string solve_line(const SolveRecord& solve) {
  return fmt::format("SOLVE in line {}: ratio {:.2g} after {}", solve.line,
                     solve.reached, counted(solve.steps, "step"));
}

std::string solve_warning(const SolveRecord& solve, const Settings& settings) {
  std::string text = fmt::format(
      "SOLVE in line {} has not converged: ratio {:.2g} after {}, wanted {:.2g}",
      solve.line, solve.reached, counted(solve.steps, "step"), solve.wanted);
  if (solve.reached <= solve.wanted)
    return text + " in two successive tests after gravity and loads have reached their "
                  "last values: give more steps";
  if (solve.block >= 0)
    text += fmt::format("; the largest unbalanced force, {:.3g}, is that of block {} "
                        "(blocks plot --colour unbalanced)",
                        solve.largest, solve.block + 1);
  const bool damped = settings.damping > 0.0 || is_damped_to_rest(settings);
  return text + (damped
                     ? ": give more steps, or look for blocks that cannot come to rest"
                     : ": nothing damps the motion; LOCDAMP, KINDAMP or DAMPING does");
}

}  // namespace blocks::run
