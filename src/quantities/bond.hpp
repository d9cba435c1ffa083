// The states of the bond of a contact with the law of a joint (docs/laws.md).
#pragma once

namespace blocks::quantities {

enum class Bond {
  bonded,    ///< acts in tension too, with the peak strengths
  weakened,  ///< acts in tension too, with the residual strengths
  failed,    ///< acts in compression only, with the residual strengths
  intact,    ///< acts in compression only, with the peak strengths
};

constexpr Bond bond_of(bool bonded, bool failed) {
  if (bonded)
    return failed ? Bond::weakened : Bond::bonded;
  return failed ? Bond::failed : Bond::intact;
}

/// The word for it in files, messages and figures.
constexpr const char* word(Bond bond) {
  switch (bond) {
  case Bond::bonded:
    return "bonded";
  case Bond::weakened:
    return "weakened";
  case Bond::failed:
    return "failed";
  case Bond::intact:
    break;
  }
  return "intact";
}

}  // namespace blocks::quantities
