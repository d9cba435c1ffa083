// Finds out whether Python has written to views of velocities and spins.
#pragma once

#include <Eigen/Core>

#include "model/blocks.hpp"

namespace blocks::python {

/// Velocities and spins as they were when Python last got a view of them, or when the
/// last steps ended while it had one.
class VelocityWatch {
 public:
  /// From now on, changes count.
  void begin(const Blocks& blocks) {
    velocity_ = blocks.velocity;
    spin_ = blocks.spin;
  }
  void end() { velocity_.resize(2, 0), spin_.resize(0); }
  /// Whether the blocks differ. False if nothing is watched, or other blocks were.
  bool has_changed(const Blocks& blocks) const {
    return velocity_.cols() > 0 && velocity_.cols() == blocks.velocity.cols() &&
           !(velocity_ == blocks.velocity && spin_ == blocks.spin);
  }
  /// Whether block b differs.
  bool has_changed(const Blocks& blocks, int b) const {
    return velocity_.col(b) != blocks.velocity.col(b) || spin_[b] != blocks.spin[b];
  }
  /// Undoes the changes.
  void restore(Blocks& blocks) const {
    blocks.velocity = velocity_;
    blocks.spin = spin_;
  }

 private:
  Eigen::Matrix2Xd velocity_;
  Eigen::VectorXd spin_;
};

}  // namespace blocks::python
