// A constant without functions, for code that is compiled for several instruction sets.
#pragma once

namespace blocks::geometry {

/// Slack of "between" and of the nearest edge, as a part of the edge's length
/// (docs/departures.md). The double nearest 1e-6, taken as an exact number.
inline constexpr double contact_slack = 1e-6;

}  // namespace blocks::geometry
