// Converts a frame to other units.
#pragma once

#include "post/read/results_reader.hpp"
#include "post/read/units.hpp"

namespace blocks::post {

/// Converts every value of the frame except its time, which the reader converts.
void convert(Frame& frame, const UnitScale& scale);

/// Converts places, forces and overlaps.
void convert(FrameContacts& contacts, const UnitScale& scale);

/// Converts every value of the cracks, with their times.
void convert(std::vector<Crack>& cracks, const UnitScale& scale);

/// Converts the interval, times and values. Throws quantities::CurveFault if a quantity
/// is unknown.
void convert(RecordedHistory& recorded, const UnitScale& scale);

}  // namespace blocks::post
