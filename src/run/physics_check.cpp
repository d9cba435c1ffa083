#include "run/physics_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "dynamics/time_step.hpp"

namespace blocks::run {
namespace {

/// A free block as seen along gravity.
struct Shadow {
  int block;
  double begin, end;  ///< [L] its extent at right angles to gravity
  double depth;       ///< [L] position of its centroid along gravity
  double line_load;   ///< [F/L] its weight divided by that extent
};

std::vector<Shadow> shadows(const Model& model) {
  const Blocks& blocks = model.blocks;
  const double g = model.settings.gravity.norm();
  const Vec2 down = model.settings.gravity / g, across(-down.y(), down.x());
  std::vector<Shadow> found;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b))
      continue;
    const Eigen::RowVectorXd along =
        across.transpose() *
        blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
    const double begin = along.minCoeff(), end = along.maxCoeff();
    found.push_back({b, begin, end, down.dot(blocks.centroid.col(b)),
                     blocks.mass[b] * g / (end - begin)});
  }
  return found;
}

/// The greatest sum of line loads on one line along gravity.
struct Column {
  double at = 0.0;         ///< [L] position of the line at right angles to gravity
  double line_load = 0.0;  ///< [F/L]
};

Column heaviest_column(const std::vector<Shadow>& shadows) {
  struct Side {
    double at, change;
  };
  std::vector<Side> sides;
  for (const Shadow& shadow : shadows) {
    sides.push_back({shadow.begin, shadow.line_load});
    sides.push_back({shadow.end, -shadow.line_load});
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.at < b.at; });
  // Columns side by side may share a strip of this width, because corners are rounded.
  const double rounding = 1e-9 * (sides.back().at - sides.front().at);
  Column best;
  double load = 0.0;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    load += sides[i].change;
    if (load > best.line_load && sides[i + 1].at - sides[i].at > rounding)
      best = {0.5 * (sides[i].at + sides[i + 1].at), load};
  }
  return best;
}

}  // namespace

std::optional<Doubt> doubt_stiffness(const Model& model) {
  constexpr double largest_share = 0.05, good_share = 0.01;  // of the block
  if (model.settings.gravity.isZero(0.0))
    return std::nullopt;
  const std::vector<Shadow> all = shadows(model);
  if (all.empty())
    return std::nullopt;
  const Column column = heaviest_column(all);
  const Shadow* lowest = nullptr;
  for (const Shadow& shadow : all)
    if (shadow.begin <= column.at && column.at <= shadow.end &&
        (lowest == nullptr || shadow.depth > lowest->depth))
      lowest = &shadow;
  if (lowest == nullptr)
    return std::nullopt;
  const double weight = column.line_load * (lowest->end - lowest->begin);
  const double size = dynamics::least_width(model.blocks, lowest->block);
  const double overlap = weight / model.settings.normal_stiffness;
  if (!(overlap > largest_share * size))
    return std::nullopt;
  return Doubt{
      fmt::format(
          "the contacts are too soft for the weight of the blocks: at rest block "
          "{} overlaps its support by about W/Kn = {:.3g}, and its width is {:.3g}",
          lowest->block + 1, overlap, size),
      fmt::format(
          "W = {:.3g} is the weight of the heaviest column; stifn = {:.2g} makes "
          "the overlap 1 % of the block",
          weight, weight / (good_share * size))};
}

std::optional<Doubt> doubt_tolerance(const Model& model) {
  const Blocks& blocks = model.blocks;
  const double ctol = model.settings.contact_tolerance;
  double least = std::numeric_limits<double>::infinity();
  int narrowest = -1;
  for (int b = 0; b < blocks.size(); ++b)
    if (const double width = dynamics::least_width(blocks, b);
        blocks.is_free(b) && width < least) {
      least = width;
      narrowest = b;
    }
  if (!(ctol > least))
    return std::nullopt;
  return Doubt{fmt::format("ctol = {:g} is more than the width of block {}, {:.3g}",
                           ctol, narrowest + 1, least),
               fmt::format("a corner may then pass through the block unnoticed; a good "
                           "ctol is a tenth of a block: {:.2g}",
                           0.1 * least)};
}

}  // namespace blocks::run
