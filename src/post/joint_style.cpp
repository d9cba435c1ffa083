#include "post/joint_style.hpp"

#include <array>

#include "post/pen.hpp"

namespace blocks::post {
namespace {

constexpr int colours = 8, rounds = 3;

}  // namespace

Colour joint_colour(int id) {
  // Blue, orange, green, black, pink, light green, violet, brown. Any two of them
  // differ by at least 17 in CIELAB, also for readers with protanopia, deuteranopia or
  // tritanopia; the lightness of the first four differs by at least 14.
  static constexpr std::array<Colour, colours> palette = {
      Colour{0.00, 0.27, 0.53}, {0.93, 0.47, 0.20}, {0.04, 0.46, 0.35},
      {0.13, 0.13, 0.13},       {0.93, 0.20, 0.47}, {0.27, 0.67, 0.60},
      {0.69, 0.44, 0.72},       {0.42, 0.24, 0.00}};
  static constexpr std::array<double, rounds> tints = {1.0, 0.72, 0.5};
  const auto index = static_cast<std::size_t>((id - 1) % (colours * rounds));
  return mix(palette[index % colours], white, tints[index / colours]);
}

void set_joint_dashes(Pen& pen, int id) {
  switch ((id - 1) / colours % rounds) {
  case 1:
    return pen.dashes({6, 3});
  case 2:
    return pen.dashes({2, 2});
  default:
    return pen.dashes({});
  }
}

std::set<int> joints_of(const Frame& frame) {
  std::set<int> found;
  for (const auto& sides : frame.joints)
    found.insert(sides.begin(), sides.end());
  found.erase(0);
  return found;
}

std::string no_joints_text() {
  return "no side of a block has a joint id at the times drawn\n  hint: blocks get "
         "joint "
         "ids from JSET, TRACES and VORONOI by the card CUT; results of older versions "
         "have none";
}

}  // namespace blocks::post
