// The certificate of the blocks in words, for `blocks check`, the listing and the
// summary.
#pragma once

#include <string>

#include "model/assembly_certificate.hpp"

namespace blocks {

/// Returns the verdict in one line: "no two of 120 blocks overlap".
std::string verdict(const AssemblyCertificate& certificate);

/// Returns the numbers of gaps, of slits made by rounding and of T-junctions in one
/// line, with the place of the widest gap: "1 gap, 0.0004 between blocks 1 and 4 at
/// (-3, 0); 2 T-junctions".
std::string joints_line(const AssemblyCertificate& certificate);

/// Returns the lines of the listing: verdict, joints, and the first `max_pairs_named`
/// pairs of each kind, with the number of further ones.
std::string full_text(const AssemblyCertificate& certificate);

}  // namespace blocks
