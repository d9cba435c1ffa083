// Arranges mapped traces inside a window exactly: where they end, meet and cross. The
// statistics of traces (docs/joint-statistics.md) are counted on this graph.
#pragma once

#include <vector>

#include "geometry/cut.hpp"

namespace blocks::geometry {

/// The traces inside a window as a plane graph. Which edges meet is exact; places are
/// rounded to the nearest doubles.
struct TraceGraph {
  struct Node {
    Vec2 place = Vec2::Zero();  ///< [L]
    int degree = 0;             ///< number of edges that meet here, >= 1
    bool on_window = false;     ///< on a side of the window
  };
  /// A straight part of a trace between two neighbouring nodes.
  struct Edge {
    int from = 0, to = 0;  ///< nodes
    int trace = 0;         ///< id of the segment
    double length = 0.0;   ///< [L]
  };
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

/// Arranges the segments and keeps what is inside the window.
///
/// window: corners [L], simple and clockwise. segments: their ids are the numbers of
/// the traces, so the segments of a polyline share one id, which is > 0. Where traces
/// coincide, the smallest id counts. What lies along a side of the window is left out,
/// and so are segments of length 0. Throws CutError if the window is not simple and
/// clockwise, or a coordinate is not finite.
TraceGraph trace_graph(const std::vector<DecimalPoint>& window,
                       const std::vector<JointSegment>& segments,
                       const ProgressFunction& progress = {});

}  // namespace blocks::geometry
