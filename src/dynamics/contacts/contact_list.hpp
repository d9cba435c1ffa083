// Contacts between the arrays of a step and the list of the model (Model::contacts).
#pragma once

#include "dynamics/contacts/contact_arrays.hpp"
#include "model/contacts.hpp"

namespace blocks::dynamics {

/// Reads the contacts of the list. Those of other pairs are left out.
void read_list(const Blocks& blocks, const std::vector<Contact>& list,
               const PairIndex& index, ContactsOfPairs& all);

/// Writes the contacts that act to the list, in the order of the pairs, with their
/// springs. Forces and overlaps are 0.
void write_list(const ContactArrays& arrays, std::vector<Contact>& list);

}  // namespace blocks::dynamics
