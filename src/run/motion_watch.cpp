#include "run/motion_watch.hpp"

#include <fmt/format.h>

namespace blocks::run {

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

}  // namespace blocks::run
