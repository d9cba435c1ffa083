// Follows the blocks of a results file through their cracks: where the material of each
// piece was in the first frame, and which sides of the pieces are faces of cracks
// (docs/cracks.md#pictures).
#pragma once

#include <vector>

#include "post/read/results_reader.hpp"

namespace blocks::post {

/// The blocks of one frame, as their cracks have made them.
struct CrackedBlocks {
  /// The first frame of the file with one outline and one centroid for each block of
  /// the frame: the places that the material of the block had in the first frame.
  /// Blocks that were made later without a crack have their present places, so that
  /// their displacement is 0. Those that were made and split between two frames of the
  /// file have NaN.
  Frame first;
  std::vector<char> later;  ///< (n) whether the block is of no block of the first frame
  /// For each block with cracks, the crack that made each of its sides: its index in
  /// ResultsReader::cracks() plus 1, 0: none. Empty for other blocks.
  std::vector<std::vector<int>> faces;
  /// (n) number of frames in which the block has split or split off. If it is the same
  /// in two frames, so are the corners.
  std::vector<int> version;
  long cracks = 0;  ///< number of cracks up to the frame
  /// Returns whether side k of block b is a face of a crack; both from 0.
  int face(int b, std::size_t k) const {
    const auto block = static_cast<std::size_t>(b);
    return block < faces.size() && k < faces[block].size() ? faces[block][k] : 0;
  }
};

/// Follows frames in the order of time. The file has no places of pieces in the first
/// frame, so they are found from the two frames around each crack: the block moves with
/// its velocity from the earlier frame to the time of the crack, and its pieces with
/// theirs from there to the later frame. The error is that of these velocities.
class CrackTracker {
 public:
  /// first: the first frame. cracks: all cracks of the file.
  CrackTracker(Frame first, std::vector<Crack> cracks);

  /// Whether blocks have split since the last frame that was followed.
  bool is_behind(const Frame& now) const { return now.cracks > blocks_.cracks; }
  /// Goes on to a frame. `before` is the one before it; if no block has split since the
  /// last call, it may be any earlier one.
  void advance(const Frame& before, const Frame& now);

  const CrackedBlocks& blocks() const { return blocks_; }
  const std::vector<Crack>& cracks() const { return cracks_; }

 private:
  void split(const Frame& before, const Frame& now);
  void place_later_blocks(const Frame& now);

  CrackedBlocks blocks_;
  std::vector<Crack> cracks_;
};

/// Returns the blocks of frame `now` of a run whose results are in several files, in
/// the order of time. Reads all frames before it if there are cracks.
CrackedBlocks cracked_blocks(const std::vector<const ResultsReader*>& parts,
                             const Frame& now);

/// Gives the cracked blocks of any frame of a results file. Reads the frames around the
/// cracks that lie between two calls, so call it in the order of the frames.
class ResultsTracker {
 public:
  explicit ResultsTracker(const ResultsReader& results);

  /// Returns the blocks of frame i; `now` is that frame. Valid until the next call.
  const CrackedBlocks& at(long i, const Frame& now);
  /// Returns the first frame as it is in the file.
  const Frame& first() const { return first_; }
  const std::vector<Crack>& cracks() const { return tracker_.cracks(); }

 private:
  const ResultsReader& results_;
  Frame first_;
  CrackTracker tracker_;
  long at_ = 0;
};

}  // namespace blocks::post
