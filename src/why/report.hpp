// The answer of `blocks why`: which contacts act between two blocks, and why.
#pragma once

#include <optional>
#include <string>

#include "audit/exact_pair_rule.hpp"
#include "geometry/overlap.hpp"
#include "why/scene.hpp"

namespace blocks::why {

struct Report {
  std::string file;
  std::optional<double> requested;  ///< the time given by the user
  int first = 0, second = 0;        ///< blocks, from 0; first < second
  audit::PairDecision decision;
  std::optional<geometry::BlockOverlap>
      overlap;  ///< empty if the interiors do not meet
};

/// Decides two blocks by the exact rule, and finds how they overlap.
Report explain(const audit::ExactPairRule& rule, int first, int second);

/// Returns the answer as text: the state, the overlap, the steps of the decision, and
/// the contacts stored in the file.
std::string text(const Report& report, const Scene& scene,
                 const audit::ExactPairRule& rule);

/// Returns one JSON object: the contacts, and the axes and candidates of each pair of
/// parts.
std::string json(const Report& report, const Scene& scene,
                 const audit::ExactPairRule& rule);

}  // namespace blocks::why
