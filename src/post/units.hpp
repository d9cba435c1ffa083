// Dimensions of quantities, and the units the user's numbers have: a deck may use any
// consistent set, so a figure says [L T^-1] until it is told m, kg, s.
#pragma once

#include <optional>
#include <string>

namespace blocks::post {

/// Powers of length, mass and time; per unit thickness like everything in a deck.
struct Dimension {
  int length = 0, mass = 0, time = 0;
  const char* si = "";     ///< its usual name where the units are m, kg, s
  const char* angle = "";  ///< "rad" or "degrees" in front
};

/// The user's units of length, mass and time.
struct Units {
  std::string length, mass, time;

  /// "m,kg,s". Throws std::runtime_error unless there are three names.
  static Units parse(const std::string& text);
};

/// "m/s", "Pa", "N/m"; "cm ms⁻²" in other units; "L T⁻¹" in none; empty for a pure
/// number.
std::string unit_text(const Dimension& dimension, const std::optional<Units>& units);

/// "⁶", "⁻¹²".
std::string superscript(int number);

}  // namespace blocks::post
