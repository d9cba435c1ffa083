#include "run/watch/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dynamics/preparation/mass_scaling.hpp"
#include "model/equilibrium.hpp"
#include "text/counted.hpp"

namespace blocks::run {

Convergence::Convergence(const deck::Solve& card, long made, bool was_below)
    : wanted_(card.ratio.value), wanted_local_(card.local_ratio()),
      max_(card.nmax.value), made_(made), below_(was_below) {}

namespace {

/// Returns the part of the way from the first ratio to the wanted one that is done, on
/// a logarithmic scale, at most 1.
double part_done(double first, double now, double wanted) {
  if (now <= wanted)
    return 1.0;
  return first > wanted ? std::log(first / now) / std::log(first / wanted) : 0.0;
}

}  // namespace

bool Convergence::is_due() const {
  const long next = made_ + 1;
  return next % deck::Solve::test_interval == 0 || next == max_;
}

void Convergence::after_step(const Model& model) {
  const bool tested = is_due();
  ++made_;
  new_decade_ = false;
  share_ = std::max(share_, static_cast<double>(made_) / static_cast<double>(max_));
  if (!tested)
    return;
  now_ = balance_of(model);
  const bool is_below =
      now_.ratio <= wanted_ && now_.local <= wanted_local_ && !loads_will_change(model);
  // Two tests that are too near each other may both see a block that passes F = 0.
  balanced_ = below_ && is_below && made_ % deck::Solve::test_interval == 0;
  below_ = is_below;
  if (const double decade = std::floor(std::log10(now_.ratio)); decade < decade_)
    decade_ = decade, new_decade_ = true;
  if (std::isnan(first_.ratio))
    first_ = now_;
  share_ =
      std::max(share_, std::min(part_done(first_.ratio, now_.ratio, wanted_),
                                part_done(first_.local, now_.local, wanted_local_)));
}

SolveRecord Convergence::record(const Model& model, int line) const {
  SolveRecord solve;
  solve.line = line;
  solve.wanted = wanted_;
  solve.reached = now_.ratio;
  solve.steps = made_;
  solve.time = model.time;
  solve.converged = balanced_;
  for (int b = 0; b < model.blocks.size(); ++b)
    if (const double force = unbalanced_force(model, b); force > solve.largest)
      solve.largest = force, solve.block = b;
  solve.wanted_local = wanted_local_;
  solve.reached_local = now_.local;
  solve.local_block = now_.block;
  solve.dt = model.time_step.dt;
  const dynamics::MassFactors factors = dynamics::mass_factors(model.blocks);
  solve.min_scale = factors.min;
  solve.largest_scale = factors.largest;
  return solve;
}

std::string solve_line(const SolveRecord& solve) {
  const std::string worst =
      solve.local_block < 0 ? "" : fmt::format(" (block {})", solve.local_block + 1);
  return fmt::format("SOLVE in line {}: ratio {:.2g}, local ratio {:.2g}{} after {}",
                     solve.line, solve.reached, solve.reached_local, worst,
                     counted(solve.steps, "step"));
}

namespace {

/// Tells which local ratio is too large; empty if none is.
std::string local_text(const SolveRecord& solve) {
  if (solve.local_block < 0 || solve.reached_local <= solve.wanted_local)
    return "";
  return fmt::format("the largest local ratio, {:.2g}, wanted {:.2g}, is that of block "
                     "{} (blocks plot --colour local_ratio)",
                     solve.reached_local, solve.wanted_local, solve.local_block + 1);
}

}  // namespace

std::string solve_warning(const SolveRecord& solve, const Settings& settings) {
  std::string text = fmt::format(
      "SOLVE in line {} has not converged: ratio {:.2g} after {}, wanted {:.2g}",
      solve.line, solve.reached, counted(solve.steps, "step"), solve.wanted);
  const std::string local = local_text(solve);
  if (solve.reached <= solve.wanted && local.empty())
    return text + " in two successive tests after gravity and loads have reached their "
                  "last values: give more steps";
  if (solve.block >= 0 && solve.reached > solve.wanted)
    text += fmt::format("; the largest unbalanced force, {:.3g}, is that of block {} "
                        "(blocks plot --colour unbalanced)",
                        solve.largest, solve.block + 1);
  if (!local.empty())
    text += "; " + local;
  const bool damped = settings.damping > 0.0 || is_damped_to_rest(settings);
  return text + (damped
                     ? ": give more steps, or look for blocks that cannot come to rest"
                     : ": nothing damps the motion; LOCDAMP, KINDAMP or DAMPING does");
}

}  // namespace blocks::run
