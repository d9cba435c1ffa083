#include "run/watch/motion_watch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/equilibrium.hpp"
#include "run/watch/deep_contact.hpp"

namespace blocks::run {
namespace {

/// Returns for each block whether some contact with a block or a symmetry plane acts on
/// it.
std::vector<char> touching(const Model& model) {
  const Blocks& blocks = model.blocks;
  std::vector<char> touches(static_cast<std::size_t>(blocks.size()));
  const auto mark = [&](int corner) {
    touches[static_cast<std::size_t>(blocks.corner_block[corner])] = 1;
  };
  for (const Contact& contact : model.contacts)
    mark(contact.corner), mark(contact.edge);
  for (const PlaneContact& contact : model.plane_contacts)
    if (contact.active)
      mark(contact.corner);
  return touches;
}

/// Returns the warning about the first block in flight, or an empty text.
std::string flight_of(const Model& model) {
  const Blocks& blocks = model.blocks;
  const double alpha = model.settings.local_damping;
  const Vec2 gravity = model.settings.gravity_at(time_of_forces(model));
  const std::vector<char> touches = touching(model);
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b) || touches[static_cast<std::size_t>(b)])
      continue;
    const double pull = (blocks.force.col(b) / blocks.mass[b] + gravity).norm();
    const double height =
        blocks.velocity.col(b).squaredNorm() / (2.0 * (1.0 - alpha) * pull);
    if (pull > 0.0 && height > model.settings.contact_tolerance)
      return fmt::format("block {} flies at time {:g} while LOCDAMP {:g} acts: local "
                         "damping falsifies flight, a block falls with {:g} of "
                         "gravity; set LOCDAMP to 0 where blocks fly",
                         b + 1, model.time, alpha, 1.0 - alpha);
  }
  return {};
}

std::string words(const Model& model, const Contact& deep) {
  const Blocks& blocks = model.blocks;
  const int a = blocks.corner_block[deep.corner], b = blocks.corner_block[deep.edge];
  return fmt::format(
      "corner {} of block {} is {:.3g} below edge {} of block {} at time {:g}, more "
      "than twice as deep as any overlap there explains: `blocks why FILE --time {:g} "
      "--block {} --block {}` tells why it acts",
      deep.corner - blocks.first_corner[a] + 1, a + 1, deep.overlap,
      deep.edge - blocks.first_corner[b] + 1, b + 1, model.time, model.time,
      std::min(a, b) + 1, std::max(a, b) + 1);
}

}  // namespace

std::vector<std::string> MotionWatch::check_step(const Model& model,
                                                 const dynamics::StepResult& moved) {
  std::vector<std::string> warnings;
  const double tolerance = model.settings.contact_tolerance;
  if (moved.largest > tolerance && !reported_.fast) {
    reported_.fast = true;
    warnings.push_back(fmt::format(
        "block {} moved a corner by {:.3g} in one step at time {:g}, more than "
        "ctol {:g}: contacts may be found late; lower FRACTION or raise ctol",
        moved.block + 1, moved.largest, model.time, tolerance));
  }
  for (; reported_exits_ < model.exits.size(); ++reported_exits_) {
    const DomainExit& exit = model.exits[reported_exits_];
    warnings.push_back(
        fmt::format("block {} left the domain at time {:g} and is fixed where it is",
                    exit.block + 1, exit.time));
  }
  return warnings;
}

bool MotionWatch::is_state_check_due(const Model& model) const {
  constexpr long steps_between = 256;  // a look costs about as much as a step
  return (!reported_.deep || has_flights(model)) && model.steps % steps_between == 0;
}

std::vector<std::string> MotionWatch::check_state(const Model& model) {
  std::vector<std::string> found;
  if (has_flights(model))
    if (std::string flight = flight_of(model); !flight.empty()) {
      reported_.flight = true;
      found.push_back(std::move(flight));
    }
  if (!reported_.deep)
    if (const auto deep = find_deep_contact(model)) {
      reported_.deep = true;
      found.push_back(words(model, *deep));
    }
  return found;
}

bool MotionWatch::has_flights(const Model& model) const {
  return model.settings.local_damping > 0.0 && !reported_.flight;
}

}  // namespace blocks::run
