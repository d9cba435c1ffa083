#include "run/builder/new_blocks.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

#include "run/builder/names.hpp"
#include "run/support/contact_memory.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

/// Returns the width or height of the corners, whichever is the larger one, [L].
double extent(const geometry::Polygon& corners) {
  Eigen::AlignedBox2d box;
  for (const Vec2& corner : corners)
    box.extend(corner);
  return box.sizes().maxCoeff();
}

}  // namespace

double density(const Context& context, long material, deck::SourceLocation where) {
  const auto& materials = context.settings.materials;
  const bool in_range = material <= std::numeric_limits<int>::max();
  if (const auto found = materials.find(static_cast<int>(material));
      in_range && found != materials.end())
    return found->second.density;
  if (context.state.unread.may_define(material, context.settings))
    return 1.0;
  context.error(where, fmt::format("there is no material {}", material),
                "materials defined: " + listed(materials));
  return 0.0;
}

bool have_space(const Context& context, long more, deck::SourceLocation where) {
  constexpr long max = 20'000'000;          // about 12 GB of state
  constexpr double bytes_of_block = 600.0;  // a block without contacts
  const auto fit_in_memory = static_cast<long>(physical_memory() / bytes_of_block);
  if (more > std::min(max, fit_in_memory)) {
    context.error(where, fmt::format("{} blocks at once", more),
                  more > max ? fmt::format("one card may make {} blocks at most", max)
                             : fmt::format("this machine has memory for about {}",
                                           fit_in_memory));
    return false;
  }
  const int allowed = context.settings.max_blocks, now = context.blocks.size();
  const long left = allowed - now;
  if (more <= left || allowed <= 0)
    return true;
  context.error(where,
                fmt::format("{} exceed{} START's maximum of {}",
                            counted(more, "more block"), more == 1 ? "s" : "", allowed),
                fmt::format("{} exist so far: {} more are possible, or raise nblok on "
                            "the START card",
                            now, left));
  return false;
}

bool may_have_corners(const Context& context, std::size_t corners,
                      const std::string& what) {
  const Settings& settings = context.settings;
  if (static_cast<long>(corners) <= settings.max_corners || settings.max_blocks <= 0)
    return true;
  context.error(fmt::format("{} has {} corners, more than START's maximum of {}", what,
                            corners, settings.max_corners),
                "raise ncmx on the START card");
  return false;
}

bool has_weight(const Context& context, const geometry::Polygon& clockwise,
                const std::string& what, const std::string& hint_if_thin) {
  const geometry::SectionProperties section = geometry::section_properties(clockwise);
  if (section.area > 0.0 && std::isfinite(section.area) && section.polar_moment > 0.0 &&
      std::isfinite(section.polar_moment))
    return true;
  const double length = extent(clockwise);
  if (const double square = length * length; std::isnormal(square * square)) {
    context.error(fmt::format("{} is too thin to calculate with, at ({:.6g}, {:.6g})",
                              what, clockwise[0].x(), clockwise[0].y()),
                  hint_if_thin);
    return false;
  }
  const bool vanishing = section.area == 0.0 || section.polar_moment == 0.0;
  context.error(fmt::format("{}: its area or second moment is too {} to calculate with",
                            what, vanishing ? "small" : "large"),
                "choose another unit of length");
  return false;
}

bool accept(const Context& context, geometry::Polygon& outline, const std::string& what,
            bool& warned, std::vector<int>* joints) {
  if (!may_have_corners(context, outline.size(), what))
    return false;
  const geometry::OutlineCheck check = geometry::check_outline(outline);
  if (check.fault != geometry::OutlineFault::none) {
    context.error(fmt::format("{}: {}", what, geometry::describe(check)),
                  "give the corners in order around the block, clockwise, each one "
                  "once");
    return false;
  }
  if (!has_weight(context, check.anticlockwise ? geometry::reversed(outline) : outline,
                  what))
    return false;
  if (check.anticlockwise) {
    if (!warned)
      context.warning(fmt::format("{}: the corners run anticlockwise", what),
                      "corner 1 is kept and the others are taken in the reverse order");
    outline = geometry::reversed(outline);
    if (joints)
      std::reverse(joints->begin(), joints->end());
  }
  if (!check.convex && !warned)
    context.warning(fmt::format("{} is not convex", what),
                    "contacts are decided faster between convex blocks: consider "
                    "cutting it in two");
  warned = warned || check.anticlockwise || !check.convex;
  return true;
}

void append(const Context& context, const std::vector<NewBlock>& blocks) {
  context.blocks.append(blocks);
  context.model.search.invalidate();
}

Vec2 place_corner(const Context& context, const Vec2& nearest) {
  return context.state.corners[context.state.section].place(nearest);
}

}  // namespace blocks::run
