// Dimensions of quantities, and the units of the user. A deck may use any consistent
// units, so a figure shows [L T^-1] unless the user names them.
#pragma once

#include <optional>
#include <string>

namespace blocks::post {

/// Powers of length, mass and time; per unit thickness, like all values of a deck.
struct Dimension {
  int length = 0, mass = 0, time = 0;
  const char* si = "";     ///< usual name of the unit if the units are m, kg, s
  const char* angle = "";  ///< "rad" or "degrees", written first
};

/// The user's units of length, mass and time.
struct Units {
  std::string length, mass, time;

  /// Reads "m,kg,s". Throws std::runtime_error unless there are three names.
  static Units parse(const std::string& text);
};

/// Returns the unit: "m/s", "Pa", "N/m"; "cm ms⁻²" in other units; "L T⁻¹" without
/// units; empty for a dimensionless quantity.
std::string unit_text(const Dimension& dimension, const std::optional<Units>& units);

/// Returns "t = 0.3 s", or "t = 0.3 s, nearest to 0.32 s" if the time asked for is
/// another one when both are written with four digits.
std::string time_text(double time, std::optional<double> asked,
                      const std::optional<Units>& units);

/// Returns a power as superscript: "⁶", "⁻¹²".
std::string superscript(int number);

}  // namespace blocks::post
