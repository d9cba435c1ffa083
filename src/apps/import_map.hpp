// `blocks import --map`: writes a deck that cuts blocks from the joints of a map.
#pragma once

#include "import_command.hpp"

namespace blocks::apps {

/// Reads the map, gives each layer a joint id, cuts, and writes the deck. Returns a
/// code of run::ExitCode.
int import_map(ImportOptions options);

}  // namespace blocks::apps
