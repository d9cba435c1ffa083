#include "run/plausibility/domain_check.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <vector>

#include "dynamics/domain.hpp"
#include "run/support/number_ranges.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

double low_of(const Model& model, int b, int axis) {
  const Blocks& blocks = model.blocks;
  return blocks.corner.row(axis)
      .segment(blocks.first_corner[b], blocks.corners_of(b))
      .minCoeff();
}
double high_of(const Model& model, int b, int axis) {
  const Blocks& blocks = model.blocks;
  return blocks.corner.row(axis)
      .segment(blocks.first_corner[b], blocks.corners_of(b))
      .maxCoeff();
}

/// Where a block crosses the limits of an axis: which limit, and how far it reaches.
struct Crossing {
  bool outside = false, below = false;
  double reaches = 0.0;
};

Crossing crossing(const Model& model, int b, int axis) {
  const double low = low_of(model, b, axis), high = high_of(model, b, axis);
  if (low < model.settings.lower[axis])
    return {true, true, low};
  return {high > model.settings.upper[axis], false, high};
}

std::string reach_text(const Model& model, int b, int axis, const BlockMakers& makers) {
  const Crossing at = crossing(model, b, axis);
  const Settings& settings = model.settings;
  const char name = axis == 0 ? 'x' : 'y';
  const auto* maker = makers.of(b);
  return fmt::format("block {}{} reaches {} = {:g}, and {}{} is {:g}", b + 1,
                     maker ? " (" + maker->text() + ")" : "", name, at.reaches, name,
                     at.below ? "min" : "max",
                     at.below ? settings.lower[axis] : settings.upper[axis]);
}

/// Returns the new free blocks that are inside or outside the domain.
std::vector<int> new_blocks(const Plan& plan, bool inside) {
  std::vector<int> found;
  for (int b = plan.first_block; b < plan.model.blocks.size(); ++b)
    if (plan.model.blocks.is_free(b) &&
        dynamics::is_inside_domain(plan.model.blocks, b, plan.model.settings) == inside)
      found.push_back(b);
  return found;
}

const std::optional<deck::SourceLocation>& place(const Plan& plan, int axis) {
  return axis == 0 ? plan.places.x_limits : plan.places.y_limits;
}

const char* card(int axis) { return axis == 0 ? "XLIMITS" : "YLIMITS"; }

}  // namespace

std::vector<Doubt> doubt_outside_domain(const Plan& plan) {
  std::array<std::vector<int>, 2> outside;
  for (const int b : new_blocks(plan, false))
    outside[crossing(plan.model, b, 0).outside ? 0 : 1].push_back(b);
  std::vector<Doubt> doubts;
  for (int axis = 0; axis < 2; ++axis)
    if (const std::vector<int>& found = outside[axis]; !found.empty())
      doubts.push_back(
          {fmt::format("{} outside the domain will be fixed: {}",
                       counted(found.size(), "block"), number_ranges(found)),
           reach_text(plan.model, found.front(), axis, plan.makers), place(plan, axis),
           card(axis)});
  return doubts;
}

std::vector<Doubt> doubt_edge_of_domain(const Plan& plan) {
  const Settings& settings = plan.model.settings;
  const std::vector<int> inside = new_blocks(plan, true);
  std::vector<Doubt> doubts;
  for (int axis = 0; axis < 2; ++axis) {
    const double rounding = 1e-9 * (settings.upper[axis] - settings.lower[axis]);
    std::vector<int> found;
    for (const int b : inside)
      if (low_of(plan.model, b, axis) - settings.lower[axis] <= rounding ||
          settings.upper[axis] - high_of(plan.model, b, axis) <= rounding)
        found.push_back(b);
    if (!found.empty())
      doubts.push_back(
          {fmt::format("{} on the edge of the domain will be fixed by the least motion "
                       "beyond it: {}",
                       counted(found.size(), "block"), number_ranges(found)),
           "rounding decides which of them move at all: make the domain a little wider",
           place(plan, axis), card(axis)});
  }
  return doubts;
}

}  // namespace blocks::run
