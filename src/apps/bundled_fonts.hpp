// Finds the fonts of the program archive, which runs on systems without fonts.
#pragma once

namespace blocks::apps {

/// Selects ../share/blocks/fonts.conf, seen from the folder of the program, as the
/// configuration of fontconfig. Does nothing if there is no such file, as in a package
/// or a build, or if the user has set FONTCONFIG_FILE. Call this before the current
/// folder changes and before anything is drawn.
void use_bundled_fonts();

}  // namespace blocks::apps
