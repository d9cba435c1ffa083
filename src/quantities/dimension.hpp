// Dimensions of quantities.
#pragma once

namespace blocks::quantities {

/// Powers of length, mass and time; per unit thickness, like all values of a deck.
struct Dimension {
  int length = 0, mass = 0, time = 0;
  const char* si = "";     ///< usual name of the unit if the units are m, kg, s
  const char* angle = "";  ///< "rad" or "degrees", written first
};

}  // namespace blocks::quantities
