// Frames of reference. Physics does not depend on the rotation, offset and scale of a
// scene, but decisions in doubles do.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::study {

using geometry::Vec2;

/// The map x -> offset + scale * R x. Times and masses do not change, so velocities and
/// accelerations are multiplied by the scale.
struct Frame {
  double cosine = 1.0, sine = 0.0;
  Vec2 offset = Vec2::Zero();  ///< [L]
  double scale = 1.0;          ///< > 0

  Vec2 turn(const Vec2& v) const {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
  }
  /// Transforms a displacement, a velocity or an acceleration.
  Vec2 vector(const Vec2& v) const { return scale * turn(v); }
  Vec2 point(const Vec2& p) const { return vector(p) + offset; }
  /// Transforms the difference of two points back to the scene's own frame.
  Vec2 back(const Vec2& d) const {
    return Vec2(cosine * d.x() + sine * d.y(), cosine * d.y() - sine * d.x()) / scale;
  }
};

struct FrameChoice {
  std::uint64_t seed = 1982;
  /// In units of the scene's length times the scale. If empty, the offset is 0, 1, 1e3,
  /// 1e6 or 1e9.
  std::optional<double> offset;
  std::optional<double> scale;  ///< if empty: 1e-3 to 1e6, also powers of two
};

/// Returns frame number `number`, which depends only on the seed and the choice. Of ten
/// angles, one is 0 and one is a convergent of tan 10 degrees (the limit of (20)). Two
/// are Pythagorean (sine and cosine rational), and six are arbitrary. All are turned
/// into a random quadrant.
Frame random_frame(const FrameChoice& choice, int number, double length);

}  // namespace blocks::study
