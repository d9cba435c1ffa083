// Cuts the outline of a CUT command into blocks (docs/joints.md).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "geometry/shared_corners.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// The result of a CUT command.
struct CutOutcome {
  /// Without density; the joints are those of the sides.
  std::vector<NewBlock> blocks;
  CutRecord record;                        ///< without number and first block
  std::vector<JointLengthRecord> lengths;  ///< without the number of the cut
  std::vector<std::string> notes;
};

struct CutOptions {
  std::uint64_t seed = 0;
  std::string folder;           ///< of the deck; names of files are relative to it
  std::string unit;             ///< of length by UNITS; empty: not known
  double max_new_blocks = 1e9;  ///< as many blocks may still be made
  /// Called with each step of the work and the part of it that is done, from 0 to 1. It
  /// may throw to stop the work.
  std::function<void(const std::string& step, double part)> progress = {};
};

/// Generates the joints, cuts and certifies. corners: the shared corners of this
/// section of the deck. Returns nothing after a fault, which has been reported at its
/// card.
std::optional<CutOutcome> cut_domain(const deck::Cut& card, deck::SourceLocation where,
                                     const geometry::SharedCorners& corners,
                                     const CutOptions& options,
                                     deck::Diagnostics& diagnostics);

}  // namespace blocks::run
