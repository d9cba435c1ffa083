// The quantities of the blocks of a frame, as figures, tables and profiles show them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "draw/colour_map.hpp"
#include "post/read/results_reader.hpp"
#include "post/read/units.hpp"
#include "quantities/model_quantity.hpp"
#include "quantities/quantity.hpp"

namespace blocks::post {

using quantities::QuantityKind;

/// A quantity with one value for each block.
struct Quantity {
  std::string label;  ///< for the colour bar
  Dimension dimension;
  Eigen::VectorXd values;  ///< (n)
  draw::Zero zero = draw::Zero::none;
  bool logarithmic = false;  ///< figures show it by its logarithm
};

/// The blocks of a frame, as quantities read them. Valid as long as the frame exists.
quantities::BlockStates states_of(const Frame& frame);

/// The contacts of a frame, as quantities read them.
std::vector<quantities::ContactState> states_of(const FrameContacts& contacts);

/// Returns the message that a file has no unbalanced forces, with a hint.
std::string no_unbalanced_text();

/// Returns the values of all blocks, (n). `first` is the first frame of the file.
/// Throws std::runtime_error if the frame has no unbalanced forces and they are asked
/// for.
Eigen::VectorXd values_of(const QuantityKind& kind, const Frame& now,
                          const Frame& first);

/// Returns what the label of a stress says about its sign: ", tension positive".
/// Returns an empty text for other quantities.
std::string sign_convention(const QuantityKind& kind, bool compression_positive);

/// True for the stresses that the material law gives, which RIGID blocks do not have.
bool is_internal_stress(const QuantityKind& kind);

/// True if the quantity changes its sign when mirrored about a vertical plane. Takes a
/// name or report name.
bool is_odd(const std::string& name);

/// Returns the values of the blocks mirrored about x = plane [L], (n): odd quantities
/// change their sign, and x becomes 2 plane - x.
Eigen::VectorXd in_mirror(const std::string& name, const Eigen::VectorXd& values,
                          double plane);

/// Returns the quantity of that name. displacement, dx and dy are relative to `first`.
/// Throws std::runtime_error that lists the names.
Quantity quantity(const std::string& name, const Frame& now, const Frame& first,
                  const FrameContacts& contacts = {});

}  // namespace blocks::post
