// What a results file keeps of its deck: the names of the units (UNITS) and of the
// materials (MATERIAL), and the symmetry planes (SPLANE). A deck without them adds
// nothing to the file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "files/hdf5_handle.hpp"
#include "model/settings.hpp"

namespace blocks::output {

struct ResultsNames {
  Units units;
  std::map<int, std::string> materials;  ///< by number; only those with a name
  std::vector<Plane> planes;
};

/// Writes the names to the group /BLOCKS, if there are any: units as a text of three
/// lines, length, mass and time; materials as a text with a line "NUMBER NAME" for
/// each.
void write_names(hid_t own, const Settings& settings);

/// Adds the planes that the group does not have yet: rows x1, y1, x2, y2 of the column
/// planes.
void write_planes(hid_t own, const std::vector<Plane>& planes);

/// Reads names and planes. Throws hdf5::Failure if they have another form.
ResultsNames read_names(hid_t own);

}  // namespace blocks::output
