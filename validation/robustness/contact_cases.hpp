// Inputs for the contact predicates, in families of what is hard for them; each case
// again from its family and number.
#pragma once

#include <array>
#include <cstdint>

#include "validation/robustness/contact_draw.hpp"

namespace blocks::robustness {

struct ContactFamily {
  const char* name;
  int weight;  ///< parts of 100 of all cases
  ContactCase (*make)(std::uint64_t number);
};

inline constexpr std::size_t contact_family_count = 11;
const std::array<ContactFamily, contact_family_count>& contact_families();

}  // namespace blocks::robustness
