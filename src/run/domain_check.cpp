#include "run/domain_check.hpp"

#include <fmt/format.h>

#include <vector>

#include "dynamics/domain.hpp"
#include "model/counted.hpp"
#include "run/number_ranges.hpp"

namespace blocks::run {
namespace {

/// Where a block crosses the limits of an axis: which limit, and how far it reaches.
struct Crossing {
  bool outside = false, below = false;
  double reaches = 0.0;
};

Crossing crossing(const Model& model, int b, int axis) {
  const Blocks& blocks = model.blocks;
  const auto along =
      blocks.corner.row(axis).segment(blocks.first_corner[b], blocks.corners_of(b));
  const double low = along.minCoeff(), high = along.maxCoeff();
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

}  // namespace

void check_domain(const Model& model, int begin, const DomainCards& cards,
                  const BlockMakers& makers, const deck::Command& motion,
                  deck::Diagnostics& diagnostics) {
  std::array<std::vector<int>, 2> outside;
  for (int b = begin; b < model.blocks.size(); ++b)
    if (model.blocks.is_free(b) &&
        !dynamics::is_inside_domain(model.blocks, b, model.settings))
      outside[crossing(model, b, 0).outside ? 0 : 1].push_back(b);
  for (int axis = 0; axis < 2; ++axis) {
    const std::vector<int>& found = outside[axis];
    if (found.empty())
      continue;
    const char* card = axis == 0 ? "XLIMITS" : "YLIMITS";
    diagnostics.warning(
        cards[axis].value_or(motion.where), cards[axis] ? card : motion.name,
        fmt::format("{} outside the domain will be fixed: {}",
                    counted(found.size(), "block"), number_ranges(found)),
        reach_text(model, found.front(), axis, makers));
  }
}

}  // namespace blocks::run
