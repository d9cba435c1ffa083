// Any text given as a deck must be refused with a message, run with finite numbers, or
// end as unsound.
#pragma once

#include <string>

namespace blocks::testing {

enum class Verdict { refused, ran, unsound };

/// Parses a deck, builds its model and runs `steps` steps of every MOTION and CYCLE.
/// `folder` has the meshes. Throws if the program would report an internal error.
Verdict try_deck(const std::string& text, const std::string& folder, int steps);

}  // namespace blocks::testing
