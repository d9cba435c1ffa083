// The names that a results file keeps of its deck: those of the units (UNITS) and of
// the materials (MATERIAL). A deck that names nothing adds nothing to the file.
#pragma once

#include <map>
#include <string>

#include "model/settings.hpp"
#include "output/hdf5_handle.hpp"

namespace blocks::output {

struct ResultsNames {
  Units units;
  std::map<int, std::string> materials;  ///< by number; only those with a name
};

/// Writes the names to the group /BLOCKS, if there are any: units as a text of three
/// lines, length, mass and time; materials as a text with a line "NUMBER NAME" for
/// each.
void write_names(hid_t own, const Settings& settings);

/// Reads them. Throws hdf5::Failure if they have another form.
ResultsNames read_names(hid_t own);

}  // namespace blocks::output
