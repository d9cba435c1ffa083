// Reads NAME.vtkhdf frame by frame, in the memory of one frame. Knows result files
// only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace blocks::post {

/// One state of the model as stored. n blocks.
struct Frame {
  double time = 0.0;
  long step = 0;
  double kinetic_energy = 0.0;
  std::vector<std::vector<Eigen::Vector2d>> outlines;  ///< [L] clockwise, per block
  std::vector<int> number, material, fixed;
  Eigen::Matrix2Xd centroid, velocity;
  Eigen::VectorXd angle, spin;
  Eigen::Matrix4Xd stress;
};

/// A contact that acted in the step that led to a frame, as stored.
struct StoredContact {
  int corner_block, corner;  ///< from 1
  int edge_block, edge;      ///< from 1; edge block 0: a symmetry plane, and its number
  double normal_force, shear_force;  ///< [F] with the dashpots
  double overlap;                    ///< [L]
};

class ResultsReader {
 public:
  /// Throws output::FileError-like std::runtime_error naming the file and what is
  /// wrong.
  explicit ResultsReader(const std::string& path);
  ~ResultsReader();
  long frames() const;
  const std::vector<double>& times() const;
  std::string title() const;
  /// 0 <= i < frames().
  Frame frame(long i) const;
  /// 0 <= i < frames().
  std::vector<StoredContact> contacts(long i) const;
  /// Index of the frame nearest in time.
  long nearest(double time) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace blocks::post
