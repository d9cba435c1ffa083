// Helpers of the layer tests: layer requests from the text of a deck.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <string>

#include "geometry/layer.hpp"

namespace blocks::geometry::testing {

inline Decimal decimal(const std::string& text) {
  const auto value = Decimal::parse(text);
  if (!value)
    throw std::invalid_argument("not a decimal: " + text);
  return *value;
}

/// Reads four corners from "x1 y1 x2 y2 x3 y3 x4 y4".
inline std::array<DecimalPoint, 4> corners(const std::string& text) {
  std::istringstream in(text);
  std::array<DecimalPoint, 4> result;
  for (auto& corner : result) {
    std::string x;
    std::string y;
    in >> x >> y;
    corner = {decimal(x), decimal(y)};
  }
  return result;
}

inline LayerRequest random_layer(const std::string& quad, int count,
                                 const std::string& angle_min = "0",
                                 const std::string& angle_max = "0") {
  LayerRequest request;
  request.corners = corners(quad);
  request.spacing = Spacing::random;
  request.count = count;
  request.angle_min = decimal(angle_min);
  request.angle_max = decimal(angle_max);
  return request;
}

/// Returns the corners of cell i of a layer: bottom left, top left, top right, bottom
/// right.
inline std::array<Vec2, 4> cell(const Layer& layer, std::size_t i) {
  std::array<Vec2, 4> result;
  for (std::size_t k = 0; k < 4; ++k) {
    result[k] =
        layer.mesh.vertices[static_cast<std::size_t>(layer.mesh.cells.at(i).at(k))];
  }
  return result;
}

inline Polygon outline_of(const Mesh& mesh, const std::vector<int>& loop) {
  Polygon polygon;
  for (const int v : loop)
    polygon.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
  return polygon;
}

}  // namespace blocks::geometry::testing
