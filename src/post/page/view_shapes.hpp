// The shapes of the blocks as the page of `blocks view` stores them. A block has one
// shape, and another one after each crack that it takes part in.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "post/page/view_store.hpp"
#include "post/read/crack_tracker.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

class ViewShapes {
 public:
  /// Resolution of strains, which are only drawn: the error of a block of 1000 pixels
  /// is a hundredth of a pixel.
  static constexpr double strain_step = 1e-5;

  explicit ViewShapes(const ResultsReader& results);

  /// Adds the next frame. Throws std::runtime_error if an outline changes by more than
  /// translation, rotation and uniform strain, unless the block has split.
  void add_frame(const Frame& now, const CrackedBlocks& cracked);

  /// Returns the index over the corners of all shapes of a corner of a block in the
  /// last frame; both count from 1. Returns -1 if there is none.
  int corner_index(int block, int corner) const;
  /// Returns the number of corners of a block in the last frame; blocks count from 1.
  int corners_of(int block) const;
  /// Returns the number of corners of all shapes so far.
  int corners() const { return first_corner_.back(); }
  int blocks() const { return static_cast<int>(last_outlines_.size()); }

  /// Returns the shape of number i of a column of frames x blocks.
  std::size_t of(std::size_t i) const { return of_[i]; }
  const std::vector<double>& origin() const { return origin_; }  ///< 2 for each shape
  const std::vector<float>& mass() const { return mass_; }
  const std::vector<float>& inertia() const { return inertia_; }

  /// Completes of(); call it after the last frame.
  void end_frames();
  /// Adds the arrays that the columns of quantities need, then the other ones.
  void store_first(ViewStore& store) const;
  void store_rest(ViewStore& store) const;
  /// Returns all joint ids in their order, with 0 as the first; empty if every id is 0.
  std::vector<int> joint_ids() const;

 private:
  /// The first arms of a block. They give the map to its current arms, which is R(turn)
  /// for a rigid block.
  struct Shape {
    int block, version;
    double angle = 0.0;
    Eigen::Matrix2Xd arms;
    Eigen::Matrix2d inverse;  ///< (arms arms^T)^-1
    double extent = 0.0;
    std::vector<int> joints, faces;  ///< of the sides
  };

  void add(Shape shape, const Eigen::Vector2d& origin, double mass, double inertia);
  void add_hidden(int b);
  Eigen::Matrix2d follow(const Frame& now, const CrackedBlocks& cracked, int b);
  [[noreturn]] void refuse(const Frame& now, int b) const;
  std::vector<std::uint16_t> joints_of_sides(const std::vector<int>& ids) const;

  const ResultsReader& results_;
  std::vector<std::vector<Eigen::Vector2d>> last_outlines_;
  std::vector<Shape> shapes_;
  std::vector<int> current_;              ///< shape of each block in the last frame
  std::vector<std::size_t> first_shape_;  ///< of each block
  std::vector<int> first_corner_ = {0};
  std::vector<double> origin_;
  std::vector<float> mass_, inertia_;
  std::vector<std::vector<int>> frames_;  ///< shape of each block, by frame
  std::vector<std::size_t> of_;
  std::vector<int> strain_;  ///< in steps
  bool strained_ = false, has_faces_ = false;
};

}  // namespace blocks::post
