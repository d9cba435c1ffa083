// Ctrl-C and SIGTERM ask a run to finish its step, write a checkpoint and stop.
#pragma once

namespace blocks::run {

/// Installs the handlers; a second signal ends the program at once.
void catch_interrupts();
bool interrupt_requested();

}  // namespace blocks::run
