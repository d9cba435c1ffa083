#include "run/motion_watch.hpp"

#include <fmt/format.h>

#include "model/equilibrium.hpp"

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
  const PlaneContacts& planes = model.plane_contacts;
  for (int i = 0; i < planes.size(); ++i)
    if (planes.active[static_cast<std::size_t>(i)])
      mark(planes.corner[i]);
  return touches;
}

}  // namespace

std::vector<std::string> MotionWatch::after(const Model& model,
                                            const dynamics::StepResult& moved) {
  std::vector<std::string> told;
  const double tolerance = model.settings.contact_tolerance;
  if (moved.largest > tolerance && !fast_told_) {
    fast_told_ = true;
    told.push_back(fmt::format(
        "block {} moved a corner by {:.3g} in one step at time {:g}, more than "
        "ctol {:g}: contacts may be found late; lower FRACTION or raise ctol",
        moved.block + 1, moved.largest, model.time, tolerance));
  }
  for (; exits_told_ < model.exits.size(); ++exits_told_) {
    const DomainExit& exit = model.exits[exits_told_];
    told.push_back(
        fmt::format("block {} left the domain at time {:g} and is fixed where it is",
                    exit.block + 1, exit.time));
  }
  return told;
}

bool MotionWatch::is_flight_due(const Model& model) const {
  constexpr long steps_between = 256;  // a test costs about as much as a step
  return model.settings.local_damping > 0.0 && !flight_told_ &&
         model.steps % steps_between == 0;
}

std::string MotionWatch::flight(const Model& model) {
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
    if (pull > 0.0 && height > model.settings.contact_tolerance) {
      flight_told_ = true;
      return fmt::format("block {} flies at time {:g} while LOCDAMP {:g} acts: local "
                         "damping falsifies "
                         "flight, a block falls with {:g} of gravity; set LOCDAMP to 0 "
                         "where blocks fly",
                         b + 1, model.time, alpha, 1.0 - alpha);
    }
  }
  return {};
}

}  // namespace blocks::run
