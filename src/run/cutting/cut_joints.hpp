// Generates the joints of a CUT command: joint sets, Voronoi cells and traces from
// files, whose loose ends are prolonged (docs/joints.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "geometry/cut.hpp"

namespace blocks::run {

/// What the generators need besides the card.
struct CutSurroundings {
  std::uint64_t seed = 0;
  std::string folder;  ///< of the deck; names of files are relative to it
  std::string unit;    ///< of length by UNITS; empty: not known
  /// [L] corners of the outline, clockwise.
  std::vector<geometry::DecimalPoint> outline;
  double max_new_blocks = 0.0;  ///< as many blocks may still be made
  /// As CutRequest::progress.
  std::function<void(const std::string& step, double part)> progress = {};
};

struct CutJoints {
  std::vector<geometry::JointSegment> segments;
  std::vector<std::string> notes;  ///< on files, ends and starts, one per line
};

/// Generates the joints. Returns nothing after a fault, which has been reported at its
/// card; all cards are examined before any joint is generated.
std::optional<CutJoints> cut_joints(const deck::Cut& card,
                                    const CutSurroundings& around,
                                    deck::Diagnostics& diagnostics);

}  // namespace blocks::run
