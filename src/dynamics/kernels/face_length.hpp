// The part of the faces that a contact with the law of a joint stands for
// (docs/laws.md#length). A Number is a number of one contact, or of all lanes of a
// vector.
#pragma once

#include "geometry/contact_constants.hpp"

namespace blocks::dynamics {

/// The edge of a contact and where its corner is along it.
template <class Number> struct EdgeLine {
  Number x, y, square;  ///< [L], [L], [L^2] the edge and the square of its length
  Number at;            ///< [L^2] position of the corner, times the length
};

/// Returns the length that a side next to the corner has in common with the edge, times
/// that of the edge, [L^2]. They form a face if they run in opposite directions and
/// overlap in projection. x, y: the side, in the direction of the edge. follows:
/// whether it lies farther along the edge than the corner.
template <class Number>
[[gnu::always_inline]] inline Number common_length(const EdgeLine<Number>& edge,
                                                   const Number& x, const Number& y,
                                                   bool follows) {
  constexpr double square_of_cosine = geometry::face_cosine * geometry::face_cosine;
  const Number none = Number{};
  const Number along = x * edge.x + y * edge.y;
  const Number low = follows ? edge.at : Number(edge.at - along);
  const Number high = follows ? Number(edge.at + along) : edge.at;
  const Number start = low > 0.0 ? low : none;
  const Number end = high < edge.square ? high : edge.square;
  const Number common = end > start ? Number(end - start) : none;
  const Number square = x * x + y * y;
  const Number faced =
      along * along >= square_of_cosine * square * edge.square ? common : none;
  return along > 0.0 ? faced : none;
}

/// Returns the stiffness of a contact, [F/L]. It grows with the length, but does not
/// shrink. per_length: [F/L^3], 0 for `usual`, the stiffness of STIFF.
template <class Number>
[[gnu::always_inline]] inline Number
stiffness_of(const Number& old, const Number& per_length, const Number& length,
             const Number& usual) {
  const Number wanted = per_length * length;
  const Number fresh = wanted > 0.0 ? wanted : usual;
  const Number kept = old > 0.0 ? old : fresh;
  return wanted > kept ? wanted : kept;
}

}  // namespace blocks::dynamics
