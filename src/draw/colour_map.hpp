// Colours of figures: materials, and quantities on perceptually uniform maps.
#pragma once

#include <string>
#include <vector>

namespace blocks::draw {

struct Colour {
  double r = 0, g = 0, b = 0;  ///< 0 to 1
};

/// Returns the colour as "#rrggbb".
std::string css(const Colour& colour);

/// Returns a muted colour, safe for colour-blind readers; repeats after forty
/// materials.
Colour material_colour(int material);

/// What zero means among the values of a quantity.
enum class Zero {
  none,    ///< nothing: a coordinate, a mass
  lowest,  ///< the block is at rest or free: speed, displacement, forces
  middle   ///< the change of sign
};

/// The colours of a range of values.
struct ColourMap {
  Colour (*stops)(double s);
  bool diverging = false;  ///< zero has the colour in the middle
  bool reversed = false;
  double first = 0.0, last = 1.0;  ///< the part of the stops that is used

  /// Returns the colour at s, 0 <= s <= 1 (clamped).
  Colour at(double s) const;
  /// Returns the map for a range of values. That of a diverging map is a part in which
  /// zero keeps the colour in the middle of the map; for a range of one sign it is the
  /// half of that sign.
  ColourMap for_range(double low, double high) const;
};

/// Returns the map of that name; a name that ends in _r has the colours in reverse.
/// Throws std::runtime_error that lists the names.
ColourMap colour_map(const std::string& name);

/// Returns the names of all maps, not reversed, the most used first.
std::vector<std::string> all_colour_maps();

/// Returns the name of the map of a quantity unless another one is asked for. If zero
/// is an ordinary value, its colour is light.
std::string usual_colour_map(Zero zero);

/// Returns the names for help and messages.
std::string colour_map_names();

/// For signed quantities: blue, near white, red; 0 <= s <= 1 (clamped), zero at s =
/// 0.5.
Colour diverging(double s);

/// For lines on white: pale orange to near black, 0 <= s <= 1 (clamped).
Colour intensity(double s);

/// Returns the relative luminance, 0 for black to 1 for white.
double luminance(const Colour& c);

/// True if white is easier to see on the colour than black.
bool is_dark(const Colour& c);

/// Returns the colour of an outline on a ground: darker on a light ground, lighter on a
/// dark one. It differs less from the ground if `faint`.
Colour outline_on(const Colour& ground, bool faint);

/// Returns the colour of the rim of a line, which has a high contrast to the line.
Colour rim_of_line(const Colour& line);

/// Mixes the fraction `share` of a with the rest of b.
Colour mix(const Colour& a, const Colour& b, double share);

}  // namespace blocks::draw
