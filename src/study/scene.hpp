// Scenes in which contact detection is hard, each with a motion known beforehand. Any
// deck can be one.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "model/model.hpp"
#include "study/frame.hpp"

namespace blocks::study {

/// What is done to the outlines before a run, as other codes round their blocks.
enum class Corners {
  sharp,
  chamfered,  ///< cut at 1 % of the shorter side
  rounded,    ///< three chords of an arc, tangent at 1 % of the shorter side
  skinned     ///< outline moved inwards by 0.1 % of the block's size
};

struct Scene {
  std::string name, what;
  Model model;        ///< in its own frame, before the first step
  long steps = 0;     ///< of a run
  double size = 1.0;  ///< [L] of a block that moves
  /// Displacement of each block after so many steps of dt, (2, n) [L].
  std::function<Eigen::Matrix2Xd(long steps, double dt)> expected;
  bool known_motion = true;  ///< expected holds at every step, not at the end only
  /// A block that falls behind its expected speed by more than this share of the
  /// fastest one expected hangs: it has snagged, though it may come far.
  double most_lost = 0.05;
  /// A block that comes less than this share of its expected way hangs. Asked of blocks
  /// whose way is longer than least_way, in units of the size.
  double least_share = 0.9, least_way = 0.05;
  /// A block that sinks along gravity by this much more than expected has lost its
  /// support, in units of the size.
  double most_sinking = 0.05;
  bool conservative = false;  ///< neither friction nor damping: energy is kept
};

/// "figure4b", "diagonal", ...
const std::vector<std::string_view>& scene_names();

/// Throws std::out_of_range when there is no such scene.
Scene make_scene(std::string_view name);

/// A deck's blocks, before its first step, as a scene. What to expect follows from a
/// run: see set_expectation in measure.hpp.
Scene scene_of_deck(const std::string& name, const Model& model);

/// A block that cannot be made in a frame: its corners coincide or its sides cross.
struct UnfitBlock : std::runtime_error {
  using runtime_error::runtime_error;
};

/// The scene in another frame. Throws UnfitBlock.
Model place(const Model& model, const Frame& frame, Corners corners);

}  // namespace blocks::study
