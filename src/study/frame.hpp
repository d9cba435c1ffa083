// A frame of reference: physics must not depend on how a scene is turned, shifted and
// scaled; decisions in doubles do.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::study {

using geometry::Vec2;

/// x -> offset + scale * R x. Time and masses stay as they are, so that velocities and
/// accelerations are multiplied by the scale.
struct Frame {
  double cosine = 1.0, sine = 0.0;
  Vec2 offset = Vec2::Zero();  ///< [L]
  double scale = 1.0;          ///< > 0

  Vec2 turn(const Vec2& v) const {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
  }
  /// A direction, velocity or acceleration.
  Vec2 vector(const Vec2& v) const { return scale * turn(v); }
  Vec2 point(const Vec2& p) const { return vector(p) + offset; }
  /// The difference of two points, in the scene's own frame.
  Vec2 back(const Vec2& d) const {
    return Vec2(cosine * d.x() + sine * d.y(), cosine * d.y() - sine * d.x()) / scale;
  }
};

struct FrameChoice {
  std::uint64_t seed = 1982;
  /// In units of the scene's length times the scale; nothing: 0, 1, 1e3, 1e6 or 1e9.
  std::optional<double> offset;
  std::optional<double> scale;  ///< nothing: 1e-3 to 1e6, also powers of two
};

/// Frame number `number`: of ten angles one is 0, one a convergent of tan 10 degrees
/// (the limit of (20)), two are Pythagorean (sine and cosine rational), all in any
/// quadrant; six are any angle. The same for the same seed everywhere.
Frame random_frame(const FrameChoice& choice, int number, double length);

}  // namespace blocks::study
