// The depths on which a decision about two parts depends, and the limits within which
// it may be kept (docs/kept-decisions.md#renewal).
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/pair_shape.hpp"
#include "geometry/contact_constants.hpp"
#include "model/kept_decisions.hpp"

namespace blocks::dynamics {

/// Adds the depths of two parts to a list.
class KeptDepths {
 public:
  KeptDepths(PairShape& shape, const BlockParts& parts, std::vector<KeptDepth>& kept)
      : shape_(shape), parts_(parts), kept_(kept) {}

  /// The two parts are apart beyond the side of an axis.
  void keep_apart(const Axis& axis) {
    add(axis, std::numeric_limits<double>::lowest(), -(1.0 - share) * slack(axis));
  }
  /// The two parts are not apart: keeps the depth of the least axis. If another axis is
  /// within the slack as well, which of the two is the least one depends on both.
  void keep_least(const Axis& axis, const std::vector<Axis>& others) {
    const geometry::filter::Estimate& depth = shape_.depth(axis);
    const double eps = slack(axis), zero = sign_per_slack * eps;
    if (shape_.depth_sign(axis.side, axis.corner.index) <= 0)
      return add(axis, -(1.0 + share) * eps, 2.0 * depth.bound);
    if (depth.value > eps)
      return add(axis, (1.0 - share) * depth.value, (1.0 + share) * depth.value);
    const Axis& next = *std::min_element(
        others.begin(), others.end(), [&](const Axis& a, const Axis& b) {
          return shape_.depth(a).value < shape_.depth(b).value;
        });
    const double next_depth = shape_.depth(next).value;
    add(axis, depth.value > zero ? depth.value / factor : -zero,
        std::min(factor * depth.value, (1.0 + share) * std::min(next_depth, eps)) +
            zero);
    if (next_depth < eps)
      add(next, (1.0 - share) * next_depth - zero, std::numeric_limits<double>::max());
  }

 private:
  static constexpr double share = geometry::renewal_share,
                          factor = geometry::renewal_factor;
  static constexpr double sign_per_slack =
      geometry::renewal_of_sign / geometry::contact_slack;

  void add(const Axis& axis, double min, double max) {
    const int own = shape_.part(axis.side.part), other = shape_.part(axis.corner.part);
    const int own_block = parts_.block(own), other_block = parts_.block(other);
    kept_.push_back({own_block, own - parts_.first_part(own_block), other_block,
                     other - parts_.first_part(other_block), axis.side.index, min,
                     max});
  }
  /// [L] the slack of the side of an axis
  double slack(const Axis& axis) const {
    const Segment& e = shape_.at(axis.side);
    return geometry::contact_slack * (e.end - e.start).norm();
  }

  PairShape& shape_;
  const BlockParts& parts_;
  std::vector<KeptDepth>& kept_;
};

}  // namespace blocks::dynamics
