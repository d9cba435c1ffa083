// Profiles across the model at some times: the subsidence trough, stress along a line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/quantity.hpp"
#include "post/results_reader.hpp"

namespace blocks::post {

/// A straight line through the model, or its upper surface.
struct ProfileLine {
  std::optional<Eigen::Vector4d> segment;  ///< x0, y0, x1, y1 [L]; none: the surface

  /// "top" or "x0,y0,x1,y1". Throws std::runtime_error.
  static ProfileLine parse(const std::string& text);
};

/// A place of the profile: a block of the first frame.
struct ProfilePlace {
  int block = 0;                      ///< from 1
  double position = 0.0;              ///< [L] x, or the distance from (x0, y0)
  std::optional<double> mirror = {};  ///< [L] x of the plane it is mirrored about
};

/// Blocks the line crosses, at the middle of the crossing; or blocks with none above
/// their centroid, at its x. Along the profile. Throws std::runtime_error when there
/// are none.
std::vector<ProfilePlace> profile_places(const Frame& first, const ProfileLine& line);

/// Both halves of a model that ends at a symmetry plane x = plane [L], along the
/// profile.
std::vector<ProfilePlace> both_halves(const std::vector<ProfilePlace>& places,
                                      double plane);

/// The quantity of those blocks in one frame, one value per place.
std::vector<double> profile_values(const std::vector<ProfilePlace>& places,
                                   const QuantityKind& kind, const Frame& now,
                                   const Frame& first);

}  // namespace blocks::post
