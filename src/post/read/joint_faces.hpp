// The parts of the faces of blocks that contacts with the law of a joint stand for.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "post/read/results_reader.hpp"
#include "quantities/bond.hpp"

namespace blocks::post {

using quantities::Bond;

/// A piece of an edge, from the corner of a contact to the middle of the face that the
/// corner ends (docs/laws.md#length). The two contacts at the ends of a face
/// cover it.
struct FacePart {
  int contact = 0;           ///< index in FrameContacts
  Eigen::Vector2d from, to;  ///< [L] on the edge; `from` is the foot of the corner
  Bond bond = Bond::bonded;
  double slip = 0.0;  ///< [L] size of the slip
};

/// Returns the parts of all contacts with a law, in the order in which they are drawn:
/// bonded ones first, then by slip. A corner without a face has none.
std::vector<FacePart> face_parts(const Frame& frame, const FrameContacts& contacts);

}  // namespace blocks::post
