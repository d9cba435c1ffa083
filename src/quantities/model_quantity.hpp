// Quantities of the contacts and of the whole model.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>

#include "quantities/dimension.hpp"
#include "quantities/state.hpp"
#include "quantities/statistic.hpp"

namespace blocks::quantities {

/// A quantity of the contacts if `contact` is set, otherwise of the model.
struct OtherKind {
  std::string label;
  Dimension dimension;
  Statistic::How natural;  ///< how the values of all contacts are reduced to one
  std::function<double(const ContactState&)> contact;
  std::function<double(const State&)> whole;

  /// Sets of_blocks[b] to the value of block b, from 0: the largest overlap of its
  /// contacts, or the sum of their forces. A block without contacts has 0.
  void of_contacts(std::span<const ContactState> contacts,
                   std::span<double> of_blocks) const;
};

/// All of them by name: contacts, normal_force, overlap, shear_force; blocks, step,
/// time.
const std::map<std::string, OtherKind>& other_kinds();

/// Finds a quantity by name in upper or lower case; nullptr if there is none.
const OtherKind* find_other(const std::string& name);

/// Lists the names of the quantities of blocks, with those of contacts reduced to
/// blocks: the largest overlap, sums of forces.
std::string block_quantity_names();

}  // namespace blocks::quantities
