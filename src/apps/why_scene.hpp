// What `blocks why` looks at: one stored state, from results or from a checkpoint.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace blocks::apps {

/// What a file remembers of a contact that acted in the step that led to its state.
struct RememberedContact {
  int corner = 0, edge = 0;                      ///< from 0, of the whole model
  double normal_force = 0.0, shear_force = 0.0;  ///< [F] with the dashpots
  double overlap = 0.0;                          ///< [L] in that step
};

struct WhyScene {
  Blocks blocks;
  double time = 0.0;
  long step = 0;
  std::vector<double> times;  ///< of all states of the file, at least one
  long frame = 0;             ///< this one, from 0
  std::vector<int> order;     ///< Model::order; empty also if the file does not tell
  std::vector<RememberedContact> contacts;
};

/// From which stored time on results hold that many blocks; nothing: never, or the file
/// is a checkpoint. Throws output::FileError.
std::optional<double> first_time_with(const std::string& path, int blocks);

/// The states of a file: of results the frame nearest in time, nothing: the last; of a
/// checkpoint its only one. Throws output::FileError.
WhyScene read_scene(const std::string& path, const std::optional<double>& time);

}  // namespace blocks::apps
