// Layers as a program of 1982 made them in plain doubles, for comparison.
#pragma once

#include "geometry/layer.hpp"

namespace blocks::validation {

enum class Crossings { ignored, checked };

/// Makes the layer of a request with the same random numbers as `cut_layer`, but in
/// doubles: widths are drawn and scaled, and sides are intersections of two lines. It
/// computes with differences of coordinates; absolute ones would be far worse away from
/// the origin. With `checked`, a side that crosses its left neighbour or a layer end is
/// drawn again up to 16 times, and then joins equal fractions. Any four corners are
/// accepted. MERGE is computed in doubles too.
geometry::Mesh naive_layer(const geometry::LayerRequest& request, Crossings crossings);

}  // namespace blocks::validation
