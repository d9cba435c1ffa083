// The colours of the lines and points of charts.
#pragma once

#include <array>
#include <cstddef>

#include "draw/colour_map.hpp"

namespace blocks::draw {

/// Number of different colours.
constexpr std::size_t line_colours = 7;

/// Colours that colour-blind readers can distinguish; they repeat.
inline Colour line_colour(std::size_t i) {
  static constexpr std::array<Colour, line_colours> palette = {
      Colour{0.00, 0.36, 0.62}, {0.80, 0.33, 0.00}, {0.00, 0.51, 0.37},
      {0.65, 0.25, 0.53},       {0.35, 0.35, 0.38}, {0.72, 0.53, 0.04},
      {0.27, 0.60, 0.82}};
  return palette[i % line_colours];
}

}  // namespace blocks::draw
