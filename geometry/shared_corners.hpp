// Doubles for the corners that touch the side of another outline: rounded to the
// nearest double, a corner inside a slanted side would end a last place before or
// behind it, and two layers that share a part of a line would overlap by that much.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "geometry/decimal.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// An outline as the deck gives it: a layer, or a block and its copies, each moved by
/// one more shift.
struct DeckOutline {
  std::vector<DecimalPoint> corners;  ///< [L], either sense of rotation
  DecimalPoint shift;                 ///< [L]
  int copies = 1;
};

/// Corners that lie strictly inside a side of another outline, on the decimals, are
/// moved out of that outline until, on the doubles, they are not inside the side: by a
/// few units in the last place of the largest coordinate, 64 at most at a time; along
/// the axis in which a side at the corner runs, if that is enough, so that lines along
/// an axis stay on it. All others keep the nearest doubles. Law: the order of the
/// outlines changes nothing; an outline that touches no other changes nothing.
class SharedCorners {
 public:
  SharedCorners() = default;
  explicit SharedCorners(const std::vector<DeckOutline>& outlines);

  /// The double point that stands for the corner whose nearest doubles these are.
  Vec2 place(const Vec2& nearest) const;

  /// How many corners do not have the nearest doubles.
  std::size_t moved() const { return places_.size(); }

 private:
  std::map<std::pair<double, double>, Vec2> places_;
};

}  // namespace blocks::geometry
