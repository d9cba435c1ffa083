// Quantities of the contacts and of the whole model.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "quantities/dimension.hpp"
#include "quantities/state.hpp"
#include "quantities/statistic.hpp"

namespace blocks::quantities {

/// A quantity of the contacts if `contact` is set, of the model if `whole` is set,
/// otherwise of the joints with a law, and then only `of_joint` is set.
struct OtherKind {
  std::string label;
  Dimension dimension;
  Statistic::How natural;  ///< how the values of all contacts are reduced to one
  std::function<double(const ContactState&)> contact;
  std::function<double(const State&)> whole;
  /// The value of a contact of one joint or of two blocks, with its sign; empty: that
  /// of `contact`.
  std::function<double(const ContactState&)> of_joint = {};
  /// How these values are reduced to one.
  Statistic::How natural_of_joint = Statistic::How::sum;
  bool per_length = false;  ///< their sum is divided by that of the lengths: a stress
  bool of_laws = false;     ///< results need the states of laws

  /// The value of a contact of one joint or of two blocks.
  double along(const ContactState& state) const {
    return of_joint ? of_joint(state) : contact(state);
  }

  /// Sets of_blocks[b] to the value of block b, from 0: the largest overlap of its
  /// contacts, or the sum of their forces. A block without contacts has 0.
  void of_contacts(std::span<const ContactState> contacts,
                   std::span<double> of_blocks) const;
};

/// All of them by name: contacts, normal_force, overlap, shear_force; bonded, failed,
/// slip, dilation, joint_length, normal_stress, shear_stress; blocks, cracks, step,
/// time, unbalanced_ratio, unbalanced:local;
/// energy:kinetic and the other entries of the energy account.
const std::map<std::string, OtherKind>& other_kinds();

/// Finds a quantity by name in upper or lower case; nullptr if there is none.
const OtherKind* find_other(const std::string& name);

/// Lists the names of the quantities of blocks, with those of contacts reduced to
/// blocks: the largest overlap, sums of forces.
std::string block_quantity_names();

/// Returns the name of a quantity, or of `others`, that is nearest to the word
/// (text/suggest.hpp); empty if none is near.
std::string nearest_quantity(std::string_view word,
                             std::vector<std::string_view> others);

}  // namespace blocks::quantities
