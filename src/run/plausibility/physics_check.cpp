#include "run/plausibility/physics_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "dynamics/preparation/time_step.hpp"
#include "geometry/contact_constants.hpp"
#include "model/safe_fraction.hpp"

namespace blocks::run {
namespace {

/// A free block as seen along gravity.
struct Shadow {
  int block;
  double begin, end;  ///< [L] its extent at right angles to gravity
  double depth;       ///< [L] position of its centroid along gravity
  double line_load;   ///< [F/L] its weight divided by that extent
};

/// Returns the median area of the free blocks, [L^2]; 0 if there is none.
double median_area(const Blocks& blocks) {
  std::vector<double> areas;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      areas.push_back(blocks.area[b]);
  if (areas.empty())
    return 0.0;
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::nth_element(areas.begin(), middle, areas.end());
  return *middle;
}

bool is_tiny(double area, double median) { return area < 1e-6 * median; }

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

/// The heaviest column and its lowest block.
struct Base {
  Column column;
  Shadow lowest;
};

/// Returns nothing if there is no gravity or no free block.
std::optional<Base> base_of_heaviest(const Model& model) {
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
  return lowest == nullptr ? std::nullopt : std::optional(Base{column, *lowest});
}

/// Returns whether nothing but gravity presses blocks together, and no bond holds them.
bool has_only_weight(const Model& model) {
  return model.loads.none() && model.drives.empty() && model.servos.empty() &&
         model.bonds_made == 0;
}

constexpr double largest_share = 0.05, good_share = 0.01;  // of the block

}  // namespace

std::vector<Doubt> doubt_stiffness(const Plan& plan) {
  const std::optional<Base> base = base_of_heaviest(plan.model);
  if (!base)
    return {};
  const auto& [column, lowest] = *base;
  const double weight = column.line_load * (lowest.end - lowest.begin);
  const double size = dynamics::min_width(plan.model.blocks, lowest.block);
  const double overlap = weight / plan.model.settings.normal_stiffness;
  if (!(overlap > largest_share * size))
    return {};
  return {
      {fmt::format(
           "the contacts are too soft for the weight of the blocks: at rest block "
           "{} overlaps its support by about W/Kn = {:.3g}, and its width is {:.3g}",
           lowest.block + 1, overlap, size),
       fmt::format(
           "W = {:.3g} is the weight of the heaviest column; stifn = {:.2g} makes "
           "the overlap 1 % of the block",
           weight, weight / (good_share * size)),
       plan.places.stiffness, "STIFF"}};
}

std::vector<Doubt> doubt_overlap(const Plan& plan) {
  const std::optional<Base> base = base_of_heaviest(plan.model);
  if (!base || !has_only_weight(plan.model))
    return {};
  const auto& [column, lowest] = *base;
  const double width = lowest.end - lowest.begin, weight = column.line_load * width;
  const double overlap = weight / plan.model.settings.normal_stiffness;
  if (!(overlap < geometry::contact_slack * width))
    return {};
  return {
      {fmt::format("the contacts are very stiff for the weight of the blocks: at "
                   "rest block {} overlaps its support by about W/Kn = {:.3g}, less "
                   "than the slack of contacts, {:.3g}",
                   lowest.block + 1, overlap, geometry::contact_slack * width),
       fmt::format("W = {:.3g} is the weight of the heaviest column; stifn = {:.2g} "
                   "makes the overlap a thousandth of the block, and steps longer",
                   weight, weight / (1e-3 * width)),
       plan.places.stiffness, "STIFF"}};
}

std::vector<Doubt> doubt_modulus(const Plan& plan) {
  const Settings& settings = plan.model.settings;
  const std::optional<Base> base =
      settings.rigid ? std::nullopt : base_of_heaviest(plan.model);
  if (!base)
    return {};
  const int material = plan.model.blocks.material[base->lowest.block];
  const double load = base->column.line_load;
  const double strain = load / settings.materials.at(material).youngs_modulus;
  if (!(strain > largest_share))
    return {};
  const auto place = plan.places.modulus.find(material);
  return {
      {fmt::format("the blocks are too soft for their weight: at rest block {} is "
                   "compressed by about {:.3g} % of its height",
                   base->lowest.block + 1, 100.0 * strain),
       fmt::format("E has the units of force per area, as 20.E9 for 20 GPa in Pa; "
                   "E = {:.2g} makes it 1 %",
                   load / good_share),
       place == plan.places.modulus.end() ? std::nullopt : std::optional(place->second),
       "MATERIAL"}};
}

std::vector<Doubt> doubt_step(const Plan& plan) {
  const Settings& settings = plan.model.settings;
  if (!chooses_fraction(settings) || settings.damping > 0.0 ||
      settings.local_damping > 0.0)
    return {};
  return {{"FRACTION is blank, and nothing damps: blocks that rattle gain energy with "
           "the largest stable step",
           "give a FRACTION of .02 or less, or damping"}};
}

std::vector<Doubt> doubt_tiny_block(const Plan& plan) {
  const Blocks& blocks = plan.model.blocks;
  const double median = median_area(blocks);
  int smallest = -1;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b) && (smallest < 0 || blocks.area[b] < blocks.area[smallest]))
      smallest = b;
  if (smallest < 0 || !is_tiny(blocks.area[smallest], median))
    return {};
  return {{fmt::format("block {} has the area {:.2g}, and the median of all is {:.2g}: "
                       "it makes the time step about {:.2g} times as short",
                       smallest + 1, blocks.area[smallest], median,
                       std::sqrt(median / blocks.area[smallest])),
           "emin and amin of CUT, or MERGE, remove such blocks"}};
}

std::vector<Doubt> doubt_tolerance(const Plan& plan) {
  const Blocks& blocks = plan.model.blocks;
  const double median = median_area(blocks);
  const double ctol = plan.model.settings.contact_tolerance;
  double min = std::numeric_limits<double>::infinity();
  int narrowest = -1;
  for (int b = 0; b < blocks.size(); ++b)
    if (const double width = dynamics::min_width(blocks, b);
        blocks.is_free(b) && !is_tiny(blocks.area[b], median) && width < min) {
      min = width;
      narrowest = b;
    }
  if (!(ctol > min))
    return {};
  return {{fmt::format("ctol = {:g} is more than the width of block {}, {:.3g}", ctol,
                       narrowest + 1, min),
           fmt::format("a corner may then pass through the block unnoticed; a good "
                       "ctol is a tenth of a block: {:.2g}",
                       0.1 * min),
           plan.places.tolerance, "BOXES"}};
}

}  // namespace blocks::run
