// One state of the blocks and contacts, as quantities read it: that of a model during a
// run, or a frame of a results file.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "model/model.hpp"

namespace blocks::quantities {

/// The corners of the blocks. Refers to the model or the outlines; [L], clockwise.
class Corners {
 public:
  using Outlines = std::vector<std::vector<Eigen::Vector2d>>;
  explicit Corners(const Blocks& blocks) : blocks_(&blocks) {}
  explicit Corners(const Outlines& outlines) : outlines_(&outlines) {}

  /// The number of corners of block b, from 0; 0 if there is no such block.
  int count(int b) const;
  /// Corner c of block b, both from 0.
  Eigen::Vector2d at(int b, int c) const;

 private:
  const Blocks* blocks_ = nullptr;
  const Outlines* outlines_ = nullptr;
};

/// Where n blocks are. Refers to their columns.
struct Positions {
  const Eigen::Matrix2Xd& centroid;  ///< [L] (2, n); NaN: not known
  Corners corners;
};

/// The columns of n blocks, with the meaning that they have in Blocks. Refers to them.
struct BlockStates : Positions {
  const Eigen::Matrix2Xd &velocity, &force;
  const Eigen::VectorXd &angle, &spin, &moment, &area, &mass, &inertia;
  const Eigen::Matrix4Xd &stress, &applied, &strain_rate;
  const std::vector<int>& material;
  /// Fixities of a model, or their numbers in a frame; the other pointer is null.
  const std::vector<Fixity>* fixity = nullptr;
  const std::vector<int>* fixed = nullptr;
  /// [F] (n) unbalanced forces (model/equilibrium.hpp); null if they are not known.
  const Eigen::VectorXd* unbalanced = nullptr;
  /// (n) local ratios (model/local_ratio.hpp); null if they are not known.
  const Eigen::VectorXd* local_ratio = nullptr;
  /// [F] (2, n) force of water on each block; null: there is none.
  const Eigen::Matrix2Xd* water = nullptr;

  int size() const { return static_cast<int>(material.size()); }
  bool is_removed(int b) const;
  bool is_free(int b) const;
  /// The number of blocks that are not removed.
  int present() const;
};

/// A contact that acts. Blocks are numbered from 1; edge block 0 is a symmetry plane.
struct ContactState {
  int corner_block = 0, edge_block = 0;
  double normal_force = 0.0, shear_force = 0.0;  ///< [F]
  double overlap = 0.0;                          ///< [L]
  LawState state = {};  ///< of the law of a joint; all 0 for other contacts
};

struct State {
  double time = 0.0;  ///< [T]
  long step = 0;
  BlockStates blocks;
  std::span<const ContactState> contacts;
  const EnergyAccount* energy = nullptr;  ///< null for a frame, which has no account
  /// Ratio of the unbalanced forces; NaN if it is not known.
  double unbalanced_ratio = std::numeric_limits<double>::quiet_NaN();
  std::size_t cracks = 0;  ///< number of cracks so far
};

/// The blocks of a model. Valid as long as they exist and their number is the same.
BlockStates states_of(const Blocks& blocks);

/// Replaces `contacts` by the acting contacts of a model, in the order in which results
/// have them: those between blocks, then those with planes.
void list_contacts(const Model& model, std::vector<ContactState>& contacts);

}  // namespace blocks::quantities
