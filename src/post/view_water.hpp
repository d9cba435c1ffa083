// The pressure of water on sides and the water table for the page of `blocks view`, in
// all frames.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "post/results_reader.hpp"
#include "post/view_shapes.hpp"
#include "post/view_store.hpp"

namespace blocks::post {

class ViewWater {
 public:
  /// Adds the next frame; its shapes must have been added.
  void add_frame(const Frame& now, const ViewShapes& shapes);

  /// Whether water presses on a side in any frame.
  bool any() const { return !sides_.empty(); }

  /// Adds the sides, as indices over the corners of all shapes, and the pressures at
  /// both ends of each side in each frame; NaN where there is none.
  void store(ViewStore& store) const;

  /// Returns the tables of all frames, each as x, y, x, y ...; null without any.
  nlohmann::ordered_json lines() const;

 private:
  struct Pressed {
    std::uint32_t side;
    float first, second;  ///< [F/L^2] with four digits
  };
  std::map<int, std::uint32_t> sides_;  ///< by the corner where they begin
  std::vector<std::vector<Pressed>> frames_;
  std::vector<std::vector<Eigen::Vector2d>> lines_;
};

}  // namespace blocks::post
