// Spacing of traces along scanlines (docs/joint-statistics.md#scanlines).
#pragma once

#include <vector>

#include "joints/network.hpp"

namespace blocks::joints {

struct Scanline {
  geometry::Vec2 from, to;  ///< [L]
};

/// The traces that a scanline meets inside the window.
struct Crossing {
  double place = 0.0;     ///< [L] along the line
  std::size_t chord = 0;  ///< which of its parts inside the window
  std::size_t piece = 0;  ///< of the network
  double cosine = 0.0;    ///< > 0, of the angle between the line and the trace's normal
};

/// Statistics of the spacings along some lines together.
struct SpacingStatistics {
  double length = 0.0;        ///< [L] of the lines inside the window
  std::size_t crossings = 0;  ///< with traces
  double frequency = 0.0;     ///< [1/L] crossings per length, P10
  /// [1/L] Terzaghi: each crossing counts 1/cosine, at most 10. Its expectation is P21
  /// of the traces, whatever the direction of the line.
  double corrected = 0.0;
  std::size_t spacings = 0;  ///< between neighbouring crossings
  double mean = 0.0;         ///< [L] of them
  /// Standard deviation over mean: 0 if regular, 1 if random, more if in clusters.
  double variation = 0.0;
};

/// Returns the crossings of a line, in order.
std::vector<Crossing> crossings_of(const Scanline& line, const Network& network);

/// Counts the crossings with the chosen pieces: chosen[i] for piece i; empty: all.
SpacingStatistics spacing_statistics(const std::vector<Scanline>& lines,
                                     const Network& network,
                                     const std::vector<char>& chosen = {});

/// Returns `count` parallel lines across the window, evenly spaced. degrees: their
/// direction.
std::vector<Scanline> parallel_scanlines(const geometry::Polygon& window,
                                         double degrees, int count);

}  // namespace blocks::joints
