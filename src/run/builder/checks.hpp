// What is tested after the card itself has acted: before motions, at the end of the
// deck, or when another card changes what it needs.
#pragma once

#include "run/builder/context.hpp"

namespace blocks::run {

// Before a motion; `motion` has the card with which time passes.

/// Tests what must hold before steps are made. There must be blocks; no symmetry plane
/// may have all blocks behind it; the time step must allow the motion. Overlapping
/// blocks cause a warning. `in_place`: the blocks are where they will be at that
/// moment.
void check_before_motion(const Context& motion, bool in_place);
/// Warns of new blocks that overlap, and proves that no others do.
void check_overlaps(const Context& motion);
/// Tests FRACTION with the present damping.
void check_fraction(const Context& motion);
/// Tests the SPLANE cards that have not been tested yet.
void check_planes(const Context& context);
/// Warns of CRACK cards by which no block can split, once for each card.
void check_cracks(const Context& context);
/// Tests the interval of HISTORY against the time step.
void check_history_interval(const Context& motion);
/// Tests the number of steps of a MOTION card.
void check_steps(const Context& motion);

/// Warns at a SOLVE or FOS card if nothing damps the motion.
void check_damping(const Context& solve);
/// Warns if gravity has another direction than the depth below a water table.
void check_direction_of_water(const Context& context);

// When all cards are read
/// Tests the blocks of an OUTPUT card.
void check_output(const Context& output);
/// Tests the blocks and laws of a HISTORY card.
void check_history(const Context& history);

}  // namespace blocks::run
