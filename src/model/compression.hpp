// How far the spring of a contact is pressed in.
#pragma once

#include <cstddef>
#include <vector>

#include "model/contacts.hpp"
#include "model/settings.hpp"

namespace blocks {

/// Returns the compression of the spring of contact i, [L] >= 0. `states` has the
/// states of the laws of joints, parallel to the contacts, or is empty. For a contact
/// with such a law, and for all contacts after INSITU, it is the overlap, since its
/// force depends on more than the compression: on received springs, dilation and the
/// past.
inline double compression(const Settings& settings,
                          const std::vector<Contact>& contacts,
                          const std::vector<LawState>& states, std::size_t i) {
  return i >= states.size() || (states[i].law == 0 && !settings.in_situ)
             ? contacts[i].normal_elastic / settings.normal_stiffness
             : contacts[i].overlap;
}

}  // namespace blocks
