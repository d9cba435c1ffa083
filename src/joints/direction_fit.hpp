// Mean and half range of the directions of a joint set.
#pragma once

#include <vector>

#include "joints/estimate.hpp"
#include "joints/network.hpp"

namespace blocks::joints {

/// The fields dip and ddev of JSET [degrees].
struct DirectionFit {
  Estimate mean, half_range;
};

/// Fits the directions of one family. If a uniform law is likelier than a normal one,
/// the intervals are those of the uniform law (fit_uniform). Otherwise the half range
/// is sqrt(3) standard deviations, so that JSET's uniform law has the same deviation.
/// middle: [degrees] near their mean. pieces: not empty.
DirectionFit fit_directions(const std::vector<Piece>& pieces, double middle);

}  // namespace blocks::joints
