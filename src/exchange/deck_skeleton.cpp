#include "exchange/deck_skeleton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "exchange/block_record.hpp"
#include "exchange/mesh_writer.hpp"

namespace blocks::exchange {
namespace {

using geometry::Vec2;

struct Extent {
  Vec2 lower = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 upper = -lower;
  double shortest_side = std::numeric_limits<double>::infinity();
  std::size_t max_corners = 0;
};

Extent extent_of(const std::vector<Outline>& outlines) {
  Extent extent;
  for (const Outline& outline : outlines) {
    extent.max_corners = std::max(extent.max_corners, outline.corners.size());
    Vec2 previous = outline.corners.back();
    for (const Vec2& corner : outline.corners) {
      extent.lower = extent.lower.cwiseMin(corner);
      extent.upper = extent.upper.cwiseMax(corner);
      extent.shortest_side = std::min(extent.shortest_side, (corner - previous).norm());
      previous = corner;
    }
  }
  return extent;
}

/// Returns the nearest multiple of `step`, a power of ten, at or beyond x in the given
/// direction, as a decimal.
std::string rounded(double x, double step, bool up) {
  const double multiple = up ? std::ceil(x / step) : std::floor(x / step);
  const int decimals = std::max(0, static_cast<int>(-std::lround(std::log10(step))));
  if (!(std::abs(multiple) < 1e12) || decimals > 15)
    return shortest(x);
  return fmt::format("{:.{}f}", multiple * step, decimals);
}

/// Returns the quote that does not occur in the text of a value.
char quote_of(const std::string& text) {
  return text.find('\'') == std::string::npos ? '\'' : '"';
}

double two_digits(double x) { return std::stod(fmt::format("{:.1e}", x)); }

}  // namespace

std::string name_in_deck(std::string name) {
  name = one_line(std::move(name));
  const bool both = name.find('\'') != name.npos && name.find('"') != name.npos;
  for (char& c : name)
    if (c == ':' || (c == '"' && both))
      c = ' ';
  const bool number = name.find_first_not_of("0123456789") == name.npos;
  return number && !name.empty() ? "material " + name : name;
}

std::string write_deck_skeleton(const std::vector<Outline>& outlines,
                                const std::map<long, std::string>& material_names,
                                const BlockSource& source) {
  const Extent extent = extent_of(outlines);
  const Vec2 size = extent.upper - extent.lower;
  const double widest = size.maxCoeff();
  const double area = size.x() * size.y();
  // The second moment of a block has this order of magnitude.
  const double moment = area * area / static_cast<double>(outlines.size());
  if (!(std::isnormal(area) && std::isnormal(moment)))
    throw std::range_error(
        fmt::format("the blocks, {:g} by {:g} in all, are too {} for a deck", size.x(),
                    size.y(), widest > 1.0 ? "large" : "small"));
  const double margin = 0.1 * widest;
  const double step = std::pow(10.0, std::floor(std::log10(margin)));
  const double one_block = std::sqrt(area / static_cast<double>(outlines.size()));
  const double tolerance =
      two_digits(std::max(0.4 * extent.shortest_side, 0.01 * one_block));
  const auto boxes = [&](double length) {
    return std::clamp(static_cast<int>((length + 2 * margin) / one_block), 1, 1000);
  };
  std::set<long> materials;
  for (const Outline& outline : outlines)
    materials.insert(outline.material);

  std::string deck = fmt::format(
      "$ Blocks of {}. Units assumed: m, kg, s. Stiffness, materials, friction and\n$ "
      "gravity are examples: replace them by your own.\nSTART, {}, {}\nBLOCKS OF {}\n",
      one_line(source.title), outlines.size(), extent.max_corners,
      one_line(source.title).substr(0, 70));
  deck += fmt::format("XLIMITS, {}, {}\nYLIMITS, {}, {}\nBOXES, {}, {}, {}\n",
                      rounded(extent.lower.x() - margin, step, false),
                      rounded(extent.upper.x() + margin, step, true),
                      rounded(extent.lower.y() - margin, step, false),
                      rounded(extent.upper.y() + margin, step, true), boxes(size.x()),
                      boxes(size.y()), shortest(tolerance));
  deck += "STIFF, 1.E8, 1.E8\nFRACTION, 0.02\n";
  for (const long material : materials) {
    const auto known = material_names.find(material);
    deck += fmt::format("MATERIAL, {}, 1.E10, 4.E9, 2500", material);
    if (known != material_names.end())
      deck += fmt::format(", {0}{1}{0}", quote_of(known->second), known->second);
    deck += '\n';
  }
  deck += source.unit == "m" ? "UNITS, m, kg, s\n"
          : source.unit.empty()
              ? "$ UNITS, m, kg, s       if these are the units of the coordinates\n"
              : fmt::format("$ The coordinates are in {}.\n", source.unit);
  deck += "RIGID\nEND\n" + source.cards;
  for (std::size_t b = 0; b < outlines.size(); ++b)
    if (outlines[b].fixed)
      deck += fmt::format("FIX, {}\n", b + 1);
  deck += "$ FIX, n fixes block n; SPLANE makes a wall. Without either, all blocks "
          "fall.\nGRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.5\nCYCLE, 100\nSTOP\n";
  return deck;
}

}  // namespace blocks::exchange
