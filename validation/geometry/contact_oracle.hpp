// The definitions of the contact predicates in MPFR, independent of CGAL and of the
// filters. Sums and products are exact: if MPFR reports rounding, the judge repeats
// them with more bits. sin 10 degrees gets as many digits as the decision needs.
#pragma once

#include "validation/geometry/contact_cases.hpp"

namespace blocks::validation {

struct ContactTruth {
  int overlap_sign;
  bool near_or_inside, between, faces_edge;
  int turn_sign;       ///< from the line from the centroid to c to edge p
  int compare_depths;  ///< of c below edges p and q
};

/// Returns the exact answers of all predicates.
ContactTruth judge(const ContactCase& k);

}  // namespace blocks::validation
