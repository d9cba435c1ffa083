// The restart tape's heir: NAME.ckpt.h5, everything a bit-identical continuation needs
// (report A.1.11, Appendix G.2, rule 26).
#pragma once

#include <string>

#include "model/model.hpp"
#include "output/results.hpp"

namespace blocks::output {

/// What a continuation needs beside the model.
struct CheckpointInfo {
  std::string deck_file;  ///< deck that wrote it
  std::string deck_text;
  std::string results;      ///< results file that belongs to it
  std::string results_run;  ///< run_id of that file
  long results_frames = 0;  ///< its frames at this moment
  long listing_bytes = 0;   ///< length of the listing beside it at this moment
  std::string version;      ///< of the program
};

/// Writes to a temporary name beside `path`, syncs, renames. Throws FileError.
void write_checkpoint(const std::string& path, const Model& model,
                      const CheckpointInfo& info);

/// Reads back bit-identically. Throws FileError: absent, foreign, damaged, newer
/// format.
Model read_checkpoint(const std::string& path, CheckpointInfo& info);

}  // namespace blocks::output
