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
  Eigen::Matrix2Xd centroid, velocity, force;
  Eigen::VectorXd angle, spin, moment, area, mass, inertia;
  Eigen::Matrix4Xd stress, applied, strain_rate;  ///< rows 11, 12, 21, 22
  int size() const { return static_cast<int>(number.size()); }
};

/// The active contacts of a frame, m of them: a corner on an edge. Blocks, corners and
/// edges count from 1; edge block 0: a symmetry plane.
struct FrameContacts {
  std::vector<int> corner_block, corner, edge_block, edge;  ///< (m)
  Eigen::Matrix2Xd point, normal;  ///< [L] the corner; outward from the edge
  Eigen::VectorXd normal_force, shear_force, overlap;  ///< [F], [F], [L]
  int size() const { return static_cast<int>(corner.size()); }
  /// (2, m) [F] on the corner's block, n Fn - t Fs (16); the opposite acts on the
  /// other one.
  Eigen::Matrix2Xd force() const;
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
  const std::string& path() const;
  /// 0 <= i < frames().
  Frame frame(long i) const;
  FrameContacts contacts(long i) const;
  /// Index of the frame nearest in time.
  long nearest(double time) const;
  /// The same for a time the run went through: throws std::runtime_error naming the
  /// first and the last when it lies outside.
  long at(double time) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace blocks::post
