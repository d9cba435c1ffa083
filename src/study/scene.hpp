// Scenes in which contact detection is hard, each with a motion known beforehand. Any
// deck can be one.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
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
  /// Two blocks that share more than this part of the smaller one have come through
  /// each other.
  double most_shared = 0.02;
  /// So have two blocks that only a shift longer than this can separate, [L].
  double most_depth = std::numeric_limits<double>::infinity();
  /// Overlaps are measured so many times, evenly spread, the last time at the end.
  long looks = 4;
  /// A block that ends farther than this from where it is expected hangs, [L].
  double most_astray = std::numeric_limits<double>::infinity();
  /// Speed lost is asked of the mean speed from start to end, and a gain counts as a
  /// loss: for motions whose phase may differ.
  bool mean_speed = false;
  /// Frames are shifted by at most so many sizes. Scenes with overlaps far below the
  /// size need a finer grid of doubles than others.
  double farthest = 1e9;
  /// The default rules pass the scene in every frame, so a failure is a fault.
  bool must_pass = true;
  /// The scene of a frame with this seed and number, for scenes whose blocks differ
  /// from frame to frame; empty: the blocks are the same in every frame.
  std::function<Scene(std::uint64_t seed, int number)> vary;
};

/// "figure4b", "diagonal", ...
const std::vector<std::string_view>& scene_names();

/// Throws std::out_of_range when there is no such scene.
Scene make_scene(std::string_view name);

/// The scene as it is in the frame with this seed and number. `varied` keeps the result
/// where the blocks differ from frame to frame.
const Scene& scene_in_frame(const Scene& scene, std::uint64_t seed, int number,
                            Scene& varied);

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
