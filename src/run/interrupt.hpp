// Handles Ctrl-C and SIGTERM: the run finishes its step, writes a checkpoint and stops.
#pragma once

namespace blocks::run {

/// Installs the signal handlers. A second signal ends the program at once.
void catch_interrupts();
bool interrupt_requested();

}  // namespace blocks::run
