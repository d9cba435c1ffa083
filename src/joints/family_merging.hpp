// Joins components of a mixture that describe one family of joints.
#pragma once

#include <vector>

namespace blocks::joints {

/// Returns the logarithm of the evidence that directions belong to one family: the
/// integral of the likelihood over mean and spread, for a uniform or a normal law,
/// whichever is larger. The mean has the density 1 / 180 and the spread (half range or
/// standard deviation) 1 / 90 per degree. off: [degrees] from any direction, not empty.
double family_evidence(const std::vector<double>& off);

/// Joins groups of directions as long as one family explains two groups better than two
/// families do, with the evidence
///
///     evidence(group 1) evidence(group 2) n1! n2! / (n1 + n2 + 1)!
///
/// for two. A mixture needs several von Mises laws for uniform directions, because
/// these have no tails. member: group of each direction, from 0. Returns the new
/// groups, numbered from 0 without gaps.
std::vector<int> merge_families(const std::vector<double>& degrees,
                                std::vector<int> member);

}  // namespace blocks::joints
