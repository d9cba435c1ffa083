// What must hold for any text given as a deck: it is refused with a message, or it
// makes a run of finite numbers or one that ends as unsound. Nothing is thrown.
#pragma once

#include <string>

namespace blocks::testing {

enum class Verdict { refused, ran, unsound };

/// Parses, builds and, where there is no error, runs `steps` steps of every MOTION and
/// CYCLE. folder: of the meshes. Throws what the program would call an internal error.
Verdict try_deck(const std::string& text, const std::string& folder, int steps);

}  // namespace blocks::testing
