// Quantities of the contacts and of the model as a whole.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>

#include "post/results_reader.hpp"
#include "post/units.hpp"

namespace blocks::post {

/// How the numbers of many blocks or contacts become one.
enum class Reduction { sum, largest, smallest, mean };

/// 0 for no numbers; sums in their order, as the run sums.
double reduce(Reduction how, const Eigen::VectorXd& values);

/// Of the contacts where `rows` is set, else of the model.
struct OtherKind {
  std::string label;
  Dimension dimension;
  Reduction natural;  ///< how the rows of contacts become one number
  std::function<Eigen::VectorXd(const FrameContacts&)> rows;  ///< one for each contact
  std::function<double(const Frame&)> whole;
};

/// By name: contacts, normal_force, overlap, shear_force; blocks, step, time.
const std::map<std::string, OtherKind>& other_kinds();

/// In any case; nullptr if there is none.
const OtherKind* find_other(const std::string& name);

/// (blocks) a quantity of the contacts, over the contacts of each block: the largest
/// overlap, the sum of the forces.
Eigen::VectorXd per_block(const OtherKind& kind, const FrameContacts& contacts,
                          int blocks);

}  // namespace blocks::post
