// The quantities of a block that can be drawn, coloured and followed in time: those of
// the report's Table F.1 and ours.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "post/results_reader.hpp"
#include "post/units.hpp"

namespace blocks::post {

/// One value per block.
struct Quantity {
  std::string label;  ///< for the colour bar
  Dimension dimension;
  Eigen::VectorXd values;  ///< (n)
  bool is_signed = false;  ///< centred on zero
};

/// What a quantity is, without its numbers.
struct QuantityKind {
  std::string name;         ///< "vx"
  std::string report_name;  ///< "VELX" of Table F.1, or empty
  std::string label;        ///< "velocity x"
  Dimension dimension;
  bool is_signed = false;
  bool additive = false;  ///< the sum over blocks is that of the model
  /// (n) values; the second frame is the first of the file.
  std::function<Eigen::VectorXd(const Frame& now, const Frame& first)> values;
};

/// All of them, the ones wanted most first.
const std::vector<QuantityKind>& quantity_kinds();

/// By name or report name in any case; nullptr if there is none.
const QuantityKind* find_quantity(const std::string& name);

/// "speed, displacement, ...".
std::string quantity_names();

/// Those, and what contacts give to each block: the largest overlap, sums of forces.
std::string block_quantity_names();

/// Does it change its sign in a mirror that stands upright? By name or report name.
bool is_odd(const std::string& name);

/// Values (n) of the blocks' mirror images, the mirror standing at x = plane [L]: odd
/// quantities change their sign, x goes to the other side.
Eigen::VectorXd in_mirror(const std::string& name, const Eigen::VectorXd& values,
                          double plane);

/// displacement, dx and dy are against `first`. Throws std::runtime_error listing the
/// names.
Quantity quantity(const std::string& name, const Frame& now, const Frame& first,
                  const FrameContacts& contacts = {});

}  // namespace blocks::post
