// Profiles across the model at given times, such as a subsidence trough or stress along
// a line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/read/frame_quantity.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

/// A straight line through the model, or its upper surface.
struct ProfileLine {
  std::optional<Eigen::Vector4d> segment;  ///< x0, y0, x1, y1 [L]; empty: the surface

  /// Reads "top" or "x0,y0,x1,y1". Throws std::runtime_error.
  static ProfileLine parse(const std::string& text);
};

/// A point of the profile: a block of the first frame.
struct ProfilePlace {
  int block = 0;                      ///< from 1
  double position = 0.0;              ///< [L] x, or the distance from (x0, y0)
  std::optional<double> mirror = {};  ///< [L] x of the plane about which it is mirrored
};

/// Returns the points along the profile. For a line, they are the blocks that it
/// crosses, at the middle of the crossing. For the surface, they are the blocks with no
/// block above their centroid, at its x. Throws std::runtime_error if there are none.
std::vector<ProfilePlace> profile_places(const Frame& first, const ProfileLine& line);

/// Returns the points of both halves of a model that ends at the symmetry plane x =
/// plane [L], in order along the profile.
std::vector<ProfilePlace> both_halves(const std::vector<ProfilePlace>& places,
                                      double plane);

/// Returns the quantity of those blocks in one frame, one value for each point.
std::vector<double> profile_values(const std::vector<ProfilePlace>& places,
                                   const QuantityKind& kind, const Frame& now,
                                   const Frame& first);

}  // namespace blocks::post
