// NAME.ckpt.h5, which replaces the restart tape of the report. It holds everything
// needed for a bit-identical continuation (report A.1.11, Appendix G.2).
#pragma once

#include <string>
#include <vector>

#include "geometry/overlap.hpp"
#include "model/model.hpp"
#include "output/results/results.hpp"

namespace blocks::output {

/// The position at which the run of a deck stopped. `frames` and `listing_bytes`
/// exclude what the end of the run adds to results and listing.
struct Progress {
  long card = 0;        ///< index of the next command
  long steps_left = 0;  ///< if > 0, a MOTION, CYCLE or SOLVE is partly done
  /// The last test of a SOLVE that is partly done found at most its ratio.
  bool below_ratio = false;
  long frames = 0;
  long samples = 0;  ///< samples of histories in the results
  long listing_bytes = 0;
  long tabled_step = -1;         ///< step of the last OUTPUT table
  double half_depth = 0.0;       ///< [L] see run/watch/soundness.hpp
  bool fast_reported = false;    ///< a fast corner was reported
  bool flight_reported = false;  ///< a flight was reported
  bool deep_reported = false;    ///< a deep contact was reported
  bool finished = false;         ///< the deck was completed
  std::string warnings = {};     ///< warnings so far, one per line
  std::vector<geometry::BlockOverlap> overlaps = {};  ///< reported so far
};

/// The data besides the model that a continuation needs.
struct CheckpointInfo {
  std::string deck_file;  ///< deck of the run
  std::string deck_text;
  std::string overrides;    ///< --set options and mesh hashes, one per line
  std::string results;      ///< results file of the run
  std::string results_run;  ///< run_id of the results file
  long results_frames = 0;  ///< number of its frames
  long listing_bytes = 0;   ///< length of the listing
  std::string version;      ///< version of the program
  Progress progress;
};

/// The version of the file format that is written and read.
inline constexpr int checkpoint_format = 23;

/// Writes a temporary file beside `path`, syncs it and renames it. Throws FileError.
void write_checkpoint(const std::string& path, const Model& model,
                      const CheckpointInfo& info);

/// Restores a model bit for bit. Throws FileError if the file is missing, not a
/// checkpoint, damaged, of another format or invalid (validate_checkpoint).
Model read_checkpoint(const std::string& path, CheckpointInfo& info);

}  // namespace blocks::output
