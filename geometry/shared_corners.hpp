// Chooses the doubles of corners that touch a side of another outline. The nearest
// doubles of a corner inside a slanted side may be a unit in the last place before or
// behind that side. Two layers that share a part of a line would then overlap by that
// much.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "geometry/decimal.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// An outline as the deck gives it: a layer, or a block with its copies. Copy i is
/// translated by i * shift.
struct DeckOutline {
  std::vector<DecimalPoint> corners;  ///< [L], clockwise or anticlockwise
  DecimalPoint shift;                 ///< [L]
  int copies = 1;
};

/// Finds corners that, in exact decimals, lie strictly inside a side of another
/// outline. Moves each of them out of that outline until its doubles are not behind the
/// side. A corner that cannot be moved so is left to the certificate. A move is a few
/// units in the last place of the largest coordinate, at most 64 at a time. It follows
/// the axis along which a side at the corner runs, if that is enough, so that
/// axis-parallel lines keep their coordinate. All other corners keep the nearest
/// doubles. Guarantees: the order of the outlines has no effect, and an outline that
/// touches no other is not changed.
class SharedCorners {
 public:
  SharedCorners() = default;
  explicit SharedCorners(const std::vector<DeckOutline>& outlines);

  /// Returns the doubles of the corner whose nearest doubles are given.
  Vec2 place(const Vec2& nearest) const;

  /// Returns how many corners do not have the nearest doubles.
  std::size_t moved() const { return places_.size(); }

 private:
  std::map<std::pair<double, double>, Vec2> places_;
};

}  // namespace blocks::geometry
