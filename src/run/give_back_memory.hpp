// Memory that the program asked for and does not use any more.
#pragma once

namespace blocks::run {

/// Gives it back to the system. What was asked for in small pieces, as outlines for the
/// certificate are, else stays with the program, in places too small for columns.
void give_back_memory();

}  // namespace blocks::run
