// Each question is asked in doubles first, then with intervals, and with exact quotients
// if an interval cannot decide.
#include "geometry/continuation.hpp"

#include "geometry/exact/continuation_questions.hpp"
#include "geometry/exact/quick_continuation.hpp"

namespace blocks::geometry {
namespace {

using sides::Interval;
using sides::Exact;

/// Asks a question with intervals, and with exact quotients if they cannot decide.
/// ask(number) gets a number of the type to use.
template <class Ask> bool decide(const Ask& ask) {
  try {
    const Interval::Protector upward;
    return ask(Interval(0));
  } catch (const CGAL::Uncertain_conversion_exception&) {
  } catch (const sides::Overflow&) {
  }
  return ask(Exact(0));
}

}  // namespace

bool is_hidden_by(const PolygonAxis& axis, Outline third, Continues which) {
  if (quick::is_free_after_shift(axis, third, which) ||
      quick::is_remote(axis, third, which))
    return false;
  return decide([&](auto number) {
    return continuation::AxisQuestion<decltype(number)>(axis).is_hidden_by(third,
                                                                           which);
  });
}

bool is_in_notch_of(const PolygonAxis& axis, Outline third) {
  return decide([&](auto number) {
    return continuation::AxisQuestion<decltype(number)>(axis).is_in_notch_of(third);
  });
}

bool is_at_joint_with(const Vec2& c, const Vec2& p1, const Vec2& p2,
                      const PolygonAxis& least_axis, Outline third) {
  return decide([&](auto number) {
    return continuation::is_at_joint<decltype(number)>(c, p1, p2, least_axis, third);
  });
}

bool crosses(Outline polygon, int side, Outline other) {
  if (const auto sure = quick::crosses(polygon, side, other))
    return *sure;
  return decide([&](auto number) {
    return continuation::crosses<decltype(number)>(polygon, side, other);
  });
}

bool exceeds_common_region(const Vec2& c, const Vec2& p1, const Vec2& p2, Outline one,
                           Outline other) {
  if (const auto sure = quick::exceeds_common_region(c, p1, p2, one, other))
    return *sure;
  return decide([&](auto number) {
    return continuation::exceeds_common_region<decltype(number)>(c, p1, p2, one, other);
  });
}

bool exceeds_separating_shift(const Vec2& c, const Vec2& p1, const Vec2& p2,
                              Outline one, Outline other) {
  if (const auto sure = quick::exceeds_separating_shift(c, p1, p2, one, other))
    return *sure;
  return decide([&](auto number) {
    return continuation::exceeds_separating_shift<decltype(number)>(c, p1, p2, one,
                                                                    other);
  });
}

}  // namespace blocks::geometry
