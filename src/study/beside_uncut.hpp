// Runs a block on a cut domain and on the same domain in one piece, side by side. A
// closed joint is not there: both motions must agree.
#pragma once

#include "study/measure.hpp"

namespace blocks::study {

/// Makes `steps` steps of both and compares them. The scene must have `uncut`. Sets
/// hung, fell_through, deep and why of the outcome; signs and single contacts are not
/// compared (docs/robustness.md#cut-domains). The trace is that of measure().
Outcome measure_beside_uncut(const Scene& scene, const Frame& frame,
                             const Variant& variant, long steps, Trace& trace);

}  // namespace blocks::study
