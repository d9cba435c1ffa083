// Memory that is needed for a part of a run alone.
#pragma once

namespace blocks::dynamics {

/// Returns memory to the system that the program has freed but the allocator still
/// holds, for example outlines that a certificate needed.
void give_back_what_is_free();

}  // namespace blocks::dynamics
