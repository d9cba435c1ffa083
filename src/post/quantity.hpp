// What a figure can be coloured by.
#pragma once

#include <Eigen/Core>
#include <string>

#include "post/results_reader.hpp"

namespace blocks::post {

/// One value per block.
struct Quantity {
  std::string label;       ///< for the colour bar
  Eigen::VectorXd values;  ///< (n)
  bool is_signed = false;  ///< centred on zero
};

/// Names: speed, displacement, rotation, s11, s12, s22, p1, p2 (principal stresses,
/// largest first, tension positive). displacement is against `first`. Throws
/// std::runtime_error listing the names.
Quantity quantity(const std::string& name, const Frame& now, const Frame& first);

}  // namespace blocks::post
