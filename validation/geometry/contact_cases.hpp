// Inputs for the contact predicates, in families of different difficulties. A family
// and a number always give the same case.
#pragma once

#include <array>
#include <cstdint>

#include "validation/geometry/contact_draw.hpp"

namespace blocks::validation {

struct ContactFamily {
  const char* name;
  int weight;  ///< share of all cases, per cent
  ContactCase (*make)(std::uint64_t number);
};

inline constexpr std::size_t contact_family_count = 11;
const std::array<ContactFamily, contact_family_count>& contact_families();

}  // namespace blocks::validation
