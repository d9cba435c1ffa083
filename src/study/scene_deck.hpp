// Writes one frame of a scene as a deck that `blocks run` runs.
#pragma once

#include <string>

#include "study/frame.hpp"
#include "study/scene.hpp"

namespace blocks::study {

/// Returns the deck of the scene in this frame. It makes `steps` steps. For a
/// domain that is cut, comments contain the
/// domain in one piece. Coordinates have all their digits, so the run makes the steps
/// of the study, bit for bit. The scene must have no loads but gravity, and no planes.
std::string deck_of_frame(const Scene& scene, const Frame& frame, long steps);

}  // namespace blocks::study
