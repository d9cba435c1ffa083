#include "draw/joint_colours.hpp"

#include <array>

#include "draw/pen.hpp"

namespace blocks::draw {
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

}  // namespace blocks::draw
