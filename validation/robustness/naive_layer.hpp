// For comparison: layers as a plain program of doubles makes them, as in 1982.
#pragma once

#include "geometry/layer.hpp"

namespace blocks::robustness {

enum class Crossings { ignored, checked };

/// The same request, the same random numbers, all in doubles: widths drawn and scaled,
/// sides by the intersection of two lines in differences (in absolute coordinates it
/// would do far worse away from the origin). checked: a side that crosses
/// its left neighbour or a layer end (in doubles) is drawn again up to 16 times and
/// then joins equal fractions. Takes any four corners. MERGE in doubles.
geometry::Mesh naive_layer(const geometry::LayerRequest& request, Crossings crossings);

}  // namespace blocks::robustness
