// Scenes in which contact detection is hard, each with a known motion. Any deck can be
// a scene.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "model/model.hpp"
#include "study/frame.hpp"

namespace blocks::study {

/// How outlines are changed before a run, as in codes that round the corners of blocks.
enum class Corners {
  sharp,
  chamfered,  ///< cut at 1 % of the shorter side
  rounded,    ///< three chords of an arc, tangent at 1 % of the shorter side
  skinned     ///< outline moved inwards by 0.1 % of the block's size
};

/// The same scene with its fixed domain in one piece, for a scene whose domain is cut
/// by joints. Block 0 is the domain and block 1 the moving block.
struct UncutScene {
  Model model;
  /// The same, but joints have left straight corners on the surface of the domain.
  Model marked;
  double gap = 0.0;  ///< [L] no two pieces are shifted against each other by more
  /// Half the sharpest angle of a wedge or a notch, rad: of the re-entrant corners of
  /// the domain and, if it has one, of the corners of the block.
  double sharpest = 0.0;
};

struct Scene {
  std::string name, what;
  Model model;        ///< in the scene's own frame, before the first step
  long steps = 0;     ///< length of a run
  double size = 1.0;  ///< [L] size of a moving block
  /// The expected displacement of each block after `steps` steps of dt, shape (2, n),
  /// [L].
  std::function<Eigen::Matrix2Xd(long steps, double dt)> expected;
  bool known_motion = true;  ///< `expected` holds at every step, not only at the end
  /// A block hangs if it falls behind its expected speed by more than this share of the
  /// fastest expected speed. It has then snagged, even if it moves far in total.
  double max_lost = 0.05;
  /// A block hangs if it moves by less than min_share of its expected displacement.
  /// This is tested if that displacement is longer than min_way, in units of the
  /// size.
  double min_share = 0.9, min_way = 0.05;
  /// A block has lost its support if it sinks along gravity by this much more than
  /// expected, in units of the size.
  double max_sinking = 0.05;
  bool conservative = false;  ///< no friction, no damping: energy is conserved
  /// Two blocks have passed through each other if they share more than this part of the
  /// smaller one.
  double max_shared = 0.02;
  /// They also have if only a shift longer than this can separate them, [L].
  double max_depth = std::numeric_limits<double>::infinity();
  /// The number of times that overlaps are measured, evenly spread, the last time at
  /// the end.
  long looks = 4;
  /// A block hangs if it ends farther than this from its expected position, [L].
  double max_astray = std::numeric_limits<double>::infinity();
  /// If set, the lost speed is that of the mean speed from start to end, and a gain
  /// counts as a loss. This suits motions whose phase may differ.
  bool mean_speed = false;
  /// The largest offset of a frame, in sizes. Scenes with overlaps far below the size
  /// need a finer spacing of doubles than others.
  double farthest = 1e9;
  /// The default rules must pass the scene in every frame; a failure is an error.
  bool must_pass = true;
  /// If set, the motion of the last block is compared with that beside this domain, and
  /// `expected` is not used.
  std::shared_ptr<const UncutScene> uncut;
  /// Frames of the same kind are counted together, see Study. May be empty.
  std::string kind;
  /// Returns the scene of a frame with this seed and number. Empty if the blocks are
  /// the same in every frame.
  std::function<Scene(std::uint64_t seed, int number)> vary;
};

/// The names of all scenes: "figure4b", "diagonal", ...
const std::vector<std::string_view>& scene_names();

/// Returns the scene with this name. Throws std::out_of_range if there is none.
Scene make_scene(std::string_view name);

/// The scene of the frame with this seed and number. `varied` holds it if the blocks
/// differ from frame to frame.
const Scene& scene_in_frame(const Scene& scene, std::uint64_t seed, int number,
                            Scene& varied);

/// Returns the blocks of a deck before its first step as a scene. set_expectation in
/// measure.hpp then sets the expected motion.
Scene scene_of_deck(const std::string& name, const Model& model);

/// Thrown if a block cannot be made in a frame because its corners coincide or its
/// sides cross.
struct UnfitBlock : std::runtime_error {
  using runtime_error::runtime_error;
};

/// Returns the model of a scene in another frame. Throws UnfitBlock.
Model place(const Model& model, const Frame& frame, Corners corners);

}  // namespace blocks::study
