// Copies contacts between the arrays of a step and the list of the model
// (Model::contacts).
#pragma once

#include "dynamics/contacts/contact_arrays.hpp"
#include "model/contacts.hpp"

namespace blocks::dynamics {

/// Reads the contacts of the list. They count as certain and as acting in the step
/// before. Contacts of pairs that are not in the index are left out. states: those of
/// the laws, (list) or empty.
void read_list(const Blocks& blocks, const std::vector<Contact>& list,
               const std::vector<JointState>& states, const PairIndex& index,
               ContactsOfPairs& all);

/// Writes the acting contacts, their springs and the states of their laws to the lists,
/// in the order of the pairs. Forces and overlaps become 0.
void write_list(const ContactArrays& arrays, std::vector<Contact>& list,
                std::vector<JointState>& states);

}  // namespace blocks::dynamics
