// Quantities of the contacts and of the whole model.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>

#include "post/results_reader.hpp"
#include "post/units.hpp"

namespace blocks::post {

/// How the values of many blocks or contacts are reduced to one.
enum class Reduction { sum, largest, smallest, mean };

/// Returns the reduced value, 0 for no values. Sums use the same order as the run.
double reduce(Reduction how, const Eigen::VectorXd& values);

/// A quantity of the contacts if `rows` is set, otherwise of the model.
struct OtherKind {
  std::string label;
  Dimension dimension;
  Reduction natural;  ///< how the values of all contacts are reduced to one
  std::function<Eigen::VectorXd(const FrameContacts&)>
      rows;  ///< one value for each contact
  std::function<double(const Frame&)> whole;
};

/// All of them by name: contacts, normal_force, overlap, shear_force; blocks, step,
/// time.
const std::map<std::string, OtherKind>& other_kinds();

/// Finds a quantity by name in upper or lower case; nullptr if there is none.
const OtherKind* find_other(const std::string& name);

/// Reduces a quantity of the contacts to one value for each block, (blocks): the
/// largest overlap, or the sum of the forces.
Eigen::VectorXd per_block(const OtherKind& kind, const FrameContacts& contacts,
                          int blocks);

}  // namespace blocks::post
