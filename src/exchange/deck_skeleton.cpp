#include "exchange/deck_skeleton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string_view>

#include "exchange/block_record.hpp"
#include "exchange/mesh_writer.hpp"

namespace blocks::exchange {
namespace {

using geometry::Vec2;

struct Extent {
  Vec2 lower = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 upper = -lower;
  double shortest_side = std::numeric_limits<double>::infinity();
  std::size_t most_corners = 0;
};

Extent extent_of(const std::vector<Outline>& outlines) {
  Extent extent;
  for (const Outline& outline : outlines) {
    extent.most_corners = std::max(extent.most_corners, outline.corners.size());
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

/// Returns the name in quotes, as the last value of a card. Characters that a deck does
/// not allow there become blanks.
std::string as_value(std::string name) {
  for (char& c : name)
    if (std::string_view("'\"$!\n\r\t").find(c) != std::string_view::npos)
      c = ' ';
  return ", '" + name + "'";
}

double two_digits(double x) { return std::stod(fmt::format("{:.1e}", x)); }

}  // namespace

std::string write_deck_skeleton(const std::vector<Outline>& outlines,
                                const std::map<long, std::string>& material_names,
                                const std::string& mesh) {
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
      one_line(mesh), outlines.size(), extent.most_corners,
      one_line(mesh).substr(0, 70));
  deck += fmt::format("XLIMITS, {}, {}\nYLIMITS, {}, {}\nBOXES, {}, {}, {}\n",
                      rounded(extent.lower.x() - margin, step, false),
                      rounded(extent.upper.x() + margin, step, true),
                      rounded(extent.lower.y() - margin, step, false),
                      rounded(extent.upper.y() + margin, step, true), boxes(size.x()),
                      boxes(size.y()), shortest(tolerance));
  deck += "STIFF, 1.E8, 1.E8\nFRACTION, 0.02\n";
  std::set<std::string> used;
  for (const long material : materials) {
    const auto known = material_names.find(material);
    const bool named =
        known != material_names.end() && used.insert(known->second).second;
    deck += fmt::format("MATERIAL, {}, 1.E10, 4.E9, 2500{}\n", material,
                        named ? as_value(known->second) : "");
  }
  deck += "$ UNITS, m, kg, s       if these are the units of the coordinates\n";
  deck += fmt::format("RIGID\nEND\nREAD9, '{}'\n", mesh);
  for (std::size_t b = 0; b < outlines.size(); ++b)
    if (outlines[b].fixed)
      deck += fmt::format("FIX, {}\n", b + 1);
  deck += "$ FIX, n fixes block n; SPLANE makes a wall. Without either, all blocks "
          "fall.\nGRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.5\nCYCLE, 100\nSTOP\n";
  return deck;
}

}  // namespace blocks::exchange
