// The topology of traces in a window: nodes, branches between them, and the parts of
// traces that the window shows (docs/joint-statistics.md#nodes-and-branches).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "joints/trace_map.hpp"

namespace blocks::joints {

/// How a branch or a trace ends.
enum class End {
  isolated,   ///< I: in the rock
  connected,  ///< C: at a node Y or X
  window,     ///< E: at the window, so what follows is not known
};

/// Numbers of nodes inside the window, by the number of branches that meet.
struct NodeCounts {
  std::size_t i = 0;        ///< one: an end in the rock
  std::size_t y = 0;        ///< three: a trace ends at another one
  std::size_t x = 0;        ///< four: two traces cross
  std::size_t more = 0;     ///< five and more; they also count in x
  std::size_t joined = 0;   ///< two ends of different traces that meet; no node
  std::size_t window = 0;   ///< E: traces that leave the window
  std::size_t degrees = 0;  ///< sum of the numbers of branches at I, Y and X
};

/// What the window shows of a trace: one connected part. A trace that leaves a concave
/// window and returns has several.
struct Piece {
  int trace = 0;        ///< number of the trace, from 1
  double length = 0.0;  ///< [L] inside the window
  int hidden = 0;       ///< number of ends beyond the window: 0, 1 or 2
  geometry::Vec2 from = geometry::Vec2::Zero();  ///< [L] an end
  geometry::Vec2 to = geometry::Vec2::Zero();    ///< [L] the other; equal for a loop
  bool from_hidden = false, to_hidden = false;   ///< whether it is beyond the window
  int connected = 0;                  ///< number of ends at another trace: 0, 1 or 2
  std::array<int, 2> hosts = {0, 0};  ///< numbers of these traces; 0: none
  double direction = 0.0;  ///< degrees from x, 0 <= direction < 180, from end to end
};

/// A part of a trace between two nodes.
struct Branch {
  double length = 0.0;  ///< [L]
  End from = End::isolated, to = End::isolated;
};

/// A straight part of a piece.
struct Part {
  geometry::Vec2 from, to;  ///< [L]
  std::size_t piece = 0;    ///< index of the piece, from 0
};

struct Network {
  double area = 0.0;         ///< [L^2] of the window
  geometry::Polygon window;  ///< [L] its corners, clockwise
  NodeCounts nodes;
  std::vector<Piece> pieces;  ///< in the order of the traces
  std::vector<Branch> branches;
  std::vector<Part> parts;
  std::size_t overshoots = 0;  ///< ends that were cut
  std::size_t overlaps = 0;    ///< ends of pieces where a trace coincides with another

  double length() const;  ///< [L] of all pieces
};

/// Arranges the traces exactly. Ends that overshoot by at most TraceMap::snap are cut.
/// Throws geometry::CutError for a window that is not simple.
Network network_of(const TraceMap& map);

}  // namespace blocks::joints
