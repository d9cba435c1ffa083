// The input of `blocks why`: one stored state, from results or from a checkpoint.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace blocks::why {

/// A stored contact, which acted in the step before the stored state.
struct RememberedContact {
  int corner = 0, edge = 0;                      ///< from 0, of the whole model
  double normal_force = 0.0, shear_force = 0.0;  ///< [F] including the dashpots
  double overlap = 0.0;                          ///< [L] in that step
  /// The state of the law of its joint (docs/laws.md); law 0: it has none. Results do
  /// not hold all of its members.
  LawState state = {};
};

struct Scene {
  Blocks blocks;
  double time = 0.0;
  long step = 0;
  std::vector<double> times;  ///< of all states in the file, at least one
  long frame = 0;             ///< index of this state, from 0
  std::vector<int> order;  ///< Model::order; also empty if the file does not contain it
  std::vector<RememberedContact> contacts;
};

/// Returns when a block was removed, as a sentence for a hint. block: from 0.
std::string removal_text(const std::string& path, int block);

/// Returns the first stored time with at least that many blocks. Returns nothing if
/// there is none, or if the file is a checkpoint. Throws files::FileError.
std::optional<double> first_time_with(const std::string& path, int blocks);

/// Reads a state. From results it reads the frame nearest to `time`, or the last one if
/// `time` is empty; a checkpoint has one state. Throws files::FileError.
Scene read_scene(const std::string& path, const std::optional<double>& time);

}  // namespace blocks::why
