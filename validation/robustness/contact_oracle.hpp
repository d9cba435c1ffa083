// The definitions of the contact predicates in MPFR: independent of CGAL and of the
// filters. Sums and products are exact (MPFR says when it rounds; the judge then takes
// more bits), and sin 10 degrees is taken to as many digits as decide.
#pragma once

#include "validation/robustness/contact_cases.hpp"

namespace blocks::robustness {

struct ContactTruth {
  int overlap_sign;
  bool near_or_inside, between, within_depth, faces_edge;
  int compare_depth;
};

ContactTruth judge(const ContactCase& k);

}  // namespace blocks::robustness
