// The restart tape's heir: NAME.ckpt.h5, everything a bit-identical continuation needs
// (report A.1.11, Appendix G.2).
#pragma once

#include <string>
#include <vector>

#include "geometry/overlap.hpp"
#include "model/model.hpp"
#include "output/results.hpp"

namespace blocks::output {

/// Where its own deck was stopped. What the end of a run adds to results and listing
/// lies behind `frames` and `listing_bytes`.
struct Progress {
  long card = 0;        ///< index of the command to go on with
  long steps_left = 0;  ///< > 0: that command is a MOTION or CYCLE begun before
  long frames = 0;
  long listing_bytes = 0;
  long tabled_step = -1;      ///< of the last OUTPUT table
  double half_depth = 0.0;    ///< [L] of the executor
  bool fast_told = false;     ///< of the executor
  bool finished = false;      ///< nothing is left to do
  std::string warnings = {};  ///< of the run so far, a line each
  std::vector<geometry::BlockOverlap> overlaps = {};  ///< told by the certificate
};

/// What a continuation needs beside the model.
struct CheckpointInfo {
  std::string deck_file;  ///< deck that wrote it
  std::string deck_text;
  std::string overrides;    ///< --set options and sums of meshes, a line each
  std::string results;      ///< results file that belongs to it
  std::string results_run;  ///< run_id of that file
  long results_frames = 0;  ///< its frames at this moment
  long listing_bytes = 0;   ///< length of the listing beside it at this moment
  std::string version;      ///< of the program
  Progress progress;
};

/// Of the files that are written and read.
inline constexpr int checkpoint_format = 10;

/// Writes to a temporary name beside `path`, syncs, renames. Throws FileError.
void write_checkpoint(const std::string& path, const Model& model,
                      const CheckpointInfo& info);

/// Reads back bit-identically. Throws FileError: absent, foreign, damaged, newer
/// format, or made up (expect_possible).
Model read_checkpoint(const std::string& path, CheckpointInfo& info);

}  // namespace blocks::output
