// Colours of figures: materials, and quantities on perceptually uniform maps.
#pragma once

namespace blocks::post {

struct Colour {
  double r = 0, g = 0, b = 0;  ///< 0 to 1
};

/// Returns a muted colour, safe for colour-blind readers; repeats after forty
/// materials.
Colour material_colour(int material);

/// For magnitudes: dark blue to yellow, 0 <= s <= 1 (clamped).
Colour sequential(double s);

/// For signed quantities: blue, near white, red; 0 <= s <= 1 (clamped), zero at s =
/// 0.5.
Colour diverging(double s);

/// For lines on white: pale orange to near black, 0 <= s <= 1 (clamped).
Colour intensity(double s);

/// Mixes the fraction `share` of a with the rest of b.
Colour mix(const Colour& a, const Colour& b, double share);

}  // namespace blocks::post
