// Colours of figures: materials, and quantities on perceptually uniform maps.
#pragma once

namespace blocks::post {

struct Colour {
  double r = 0, g = 0, b = 0;  ///< 0 to 1
};

/// Muted, told apart by colour-blind eyes; repeats after forty materials.
Colour material_colour(int material);

/// Dark blue to yellow, 0 <= s <= 1 (clamped): magnitudes.
Colour sequential(double s);

/// Blue, near white, red; s = 0.5 is zero (clamped): signed quantities.
Colour diverging(double s);

/// Pale orange to near black, 0 <= s <= 1 (clamped): lines on white.
Colour intensity(double s);

/// A part `share` of a, the rest of b.
Colour mix(const Colour& a, const Colour& b, double share);

}  // namespace blocks::post
