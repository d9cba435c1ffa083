// The points that cards list by their coordinates.
#pragma once

#include <cstddef>
#include <vector>

#include "deck/commands.hpp"

namespace blocks::deck {

/// Returns the points with these coordinates; there are as many x as y.
inline std::vector<geometry::DecimalPoint> points_of(const std::vector<Exact>& x,
                                                     const std::vector<Exact>& y) {
  std::vector<geometry::DecimalPoint> points;
  for (std::size_t i = 0; i < x.size(); ++i)
    points.push_back({x[i].value, y[i].value});
  return points;
}

}  // namespace blocks::deck
