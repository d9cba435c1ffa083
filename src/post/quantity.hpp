// The quantities of a block that can be drawn and plotted over time: those of Table F.1
// of the report, and others.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "post/colour_map.hpp"
#include "post/results_reader.hpp"
#include "post/units.hpp"

namespace blocks::post {

/// A quantity with one value for each block.
struct Quantity {
  std::string label;  ///< for the colour bar
  Dimension dimension;
  Eigen::VectorXd values;  ///< (n)
  Zero zero = Zero::none;
};

/// The description of a quantity, without its values.
struct QuantityKind {
  std::string name;         ///< "vx"
  std::string report_name;  ///< "VELX" of Table F.1, or empty
  std::string label;        ///< "velocity x"
  Dimension dimension;
  bool is_signed = false;
  bool additive = false;  ///< the sum over blocks is the value of the model
  /// Returns the values, (n); the second frame is the first of the file.
  std::function<Eigen::VectorXd(const Frame& now, const Frame& first)> values;
};

/// Returns what the label of a stress says about its sign: ", tension positive".
/// Returns an empty text for other quantities.
std::string sign_convention(const QuantityKind& kind, bool compression_positive);

/// True for the stresses that the material law gives, which RIGID blocks do not have.
bool is_internal_stress(const QuantityKind& kind);

/// All of them, the most used first.
const std::vector<QuantityKind>& quantity_kinds();

/// Finds a quantity by name or report name, in upper or lower case; nullptr if there is
/// none.
const QuantityKind* find_quantity(const std::string& name);

/// Lists the names: "speed, displacement, ...".
std::string quantity_names();

/// Lists those names and the quantities of contacts reduced to blocks: the largest
/// overlap, sums of forces.
std::string block_quantity_names();

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
