// Reads NAME.vtkhdf frame by frame, with one frame in memory. Independent of the model
// and the run.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "model/law_state.hpp"
#include "post/read/results_cracks.hpp"
#include "post/read/units.hpp"

namespace blocks::post {

/// A part of a side on which the pressure of water is linear.
struct WetSide {
  int block = 0, side = 0;              ///< from 0
  std::array<Eigen::Vector2d, 2> ends;  ///< [L]
  Eigen::Vector2d share;                ///< of the side: 0 at its first corner
  Eigen::Vector2d pressure;             ///< [F/L^2] at both ends, >= 0
};

/// One stored state of the model, with n blocks. The outline of a removed block is
/// empty, and its numbers other than number, material and fixed are NaN.
struct Frame {
  double time = 0.0;
  long step = 0;
  double kinetic_energy = 0.0;
  std::vector<std::vector<Eigen::Vector2d>> outlines;  ///< [L] clockwise, per block
  /// Joint id of the side that begins at each corner of `outlines`, >= 0; empty if the
  /// file has none, so all are 0.
  std::vector<std::vector<int>> joints;
  std::vector<WetSide> wet_sides;  ///< in the order of blocks and sides
  Eigen::Matrix2Xd water_force;    ///< [F] (2, n); empty if the file has none
  /// [L] The water table from the left to the right, longer than the model is wide;
  /// empty without one.
  std::vector<Eigen::Vector2d> water_line;
  std::vector<int> number, material;
  /// The block from which each block split off, 0: none; empty if the file has none.
  std::vector<int> parent;
  long cracks = 0;         ///< number of cracks so far
  std::vector<int> fixed;  ///< 0: free, 1: fixed, 2: left the domain, 3: removed
  Eigen::Matrix2Xd centroid, velocity, force;
  Eigen::VectorXd angle, spin, moment, area, mass, inertia;
  Eigen::Matrix4Xd stress, applied, strain_rate;  ///< rows 11, 12, 21, 22
  bool compression_positive = false;              ///< sign of stress and applied
  Eigen::VectorXd unbalanced;  ///< [F] empty if the file has no unbalanced forces
  double unbalanced_ratio = std::numeric_limits<double>::quiet_NaN();  ///< or NaN
  Eigen::VectorXd local_ratio;  ///< empty like `unbalanced`
  int size() const { return static_cast<int>(number.size()); }
  bool is_removed(int b) const { return fixed[static_cast<std::size_t>(b)] == 3; }
  /// Returns the number of blocks that are not removed.
  int count_present() const;
};

/// The m active contacts of a frame, each of a corner on an edge. Blocks, corners and
/// edges count from 1; edge block 0 means a symmetry plane.
struct FrameContacts {
  std::vector<int> corner_block, corner, edge_block, edge;  ///< (m)
  Eigen::Matrix2Xd point, normal;  ///< [L] the corner; outward normal of the edge
  Eigen::VectorXd normal_force, shear_force, overlap;  ///< [F], [F], [L]
  /// (m) What the laws of joints remember (docs/laws.md); empty if the file has none.
  std::vector<LawState> states;
  int size() const { return static_cast<int>(corner.size()); }
  /// Returns the forces on the blocks of the corners, n Fn - t Fs (16), [F], (2, m).
  /// The opposite forces act on the other blocks.
  Eigen::Matrix2Xd force() const;
};

/// The samples of one request of the HISTORY card, with q quantities.
struct RecordedHistory {
  double interval = 0.0;                ///< [T]
  std::vector<std::string> quantities;  ///< (q) names of curves
  std::vector<double> time;             ///< (rows) [T] multiples of the interval
  Eigen::MatrixXd values;               ///< (q, rows)
};

/// A symmetry plane through a and b; the blocks are on its left.
struct PlaneLine {
  Eigen::Vector2d a, b;  ///< [L]
};

class ResultsReader {
 public:
  /// Opens the file. Throws std::runtime_error that names the file and the error.
  explicit ResultsReader(const std::string& path);
  ~ResultsReader();
  long frames() const;
  const std::vector<double>& times() const;
  std::string title() const;
  const std::string& path() const;
  /// Returns the names of the materials that have one, by number (MATERIAL card).
  const std::map<int, std::string>& material_names() const;
  /// Returns the symmetry planes that the run has had so far.
  std::vector<PlaneLine> planes() const;
  /// Returns the units of all times and values: those of the deck (UNITS card) or of
  /// show_in(), if there are any.
  const std::optional<Units>& units() const;
  /// From now on all times and values are in these units. They are converted if the
  /// deck names its units; otherwise these are taken to be the units of the deck.
  /// Throws std::runtime_error if the conversion is not known, so that nothing is shown
  /// with a wrong unit.
  void show_in(const Units& units);
  /// Changes the sign of the stresses in all frames that are read from now on:
  /// compression is positive instead of tension.
  void make_compression_positive();
  bool is_compression_positive() const;
  /// Reads frame i, 0 <= i < frames().
  Frame frame(long i) const;
  /// Returns the outlines of all blocks of frame i. Those of removed blocks are from
  /// the last earlier frame that shows them, or empty if there is none.
  std::vector<std::vector<Eigen::Vector2d>> last_outlines(long i) const;
  FrameContacts contacts(long i) const;
  /// Whether the contacts of some frame have the laws of joints.
  bool has_laws() const;
  /// Whether the frames have unbalanced forces (docs/rest.md#the-ratio).
  bool has_unbalanced() const;
  /// Reads all cracks up to the last frame, in the order in which blocks split; none if
  /// the deck has no CRACK card. The first Frame::cracks of them belong to a frame.
  std::vector<Crack> cracks() const;
  /// Reads the histories that the run recorded, in the order of time; those without
  /// samples are left out.
  std::vector<RecordedHistory> recorded() const;
  /// Returns the index of the frame nearest in time; the last one of that time.
  long nearest(double time) const;
  /// Returns the same. Throws std::runtime_error, with the first and the last time, if
  /// the time is outside the run.
  long at(double time) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace blocks::post
