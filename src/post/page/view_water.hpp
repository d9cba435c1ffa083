// The pressure of water on sides and the water table for the page of `blocks view`, in
// all frames.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "post/page/view_shapes.hpp"
#include "post/page/view_store.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

/// The parts of sides that water presses in any frame. A side may have several parts,
/// whose ends move along it from frame to frame.
class ViewWater {
 public:
  /// Adds the next frame; its shapes must have been added.
  void add_frame(const Frame& now, const ViewShapes& shapes);

  /// Whether water presses on a side in any frame.
  bool any() const { return !parts_.empty(); }

  /// Adds the sides of the parts, as indices over the corners of all shapes, the ends
  /// of each part in each frame as shares of its side, and the pressures there; NaN
  /// where the part is dry.
  void store(ViewStore& store) const;

  /// Returns the tables of all frames, each as x, y, x, y ...; null without any.
  nlohmann::ordered_json lines() const;

 private:
  struct Pressed {
    std::uint32_t part;
    Eigen::Vector2d share;       ///< of the side
    std::array<float, 2> value;  ///< [F/L^2] with four digits
  };
  /// By the corner where the side begins, and the number of the part on it.
  std::map<std::pair<int, int>, std::uint32_t> parts_;
  std::vector<std::vector<Pressed>> frames_;
  std::vector<std::vector<Eigen::Vector2d>> lines_;
};

}  // namespace blocks::post
