// Results at many times for other programs: a PVD collection of VTU files, or CSV.
#pragma once

#include <string>
#include <vector>

#include "post/results_reader.hpp"

namespace blocks::post {

/// What was written, in words for the user.
struct SeriesFiles {
  std::vector<std::string> names;  ///< those to be opened
  long blocks = 0, contacts = 0;   ///< rows over all times
};

/// NAME.pvd (blocks as polygons, the quantities of the results file as cell data) and
/// NAME_contacts.pvd (contacts as points with place, normal, force, overlap) over VTU
/// files in the folder NAME_vtu. An older folder is kept as NAME_vtu.bak. One frame in
/// memory at a time. Throws output::FileError.
SeriesFiles write_pvd(const std::string& path, const ResultsReader& results,
                      const std::vector<long>& frames);

/// NAME.csv (a row for each block and time) and NAME_contacts.csv (a row for each
/// acting contact and time); numbers read back bit for bit. Throws output::FileError.
SeriesFiles write_csv(const std::string& path, const ResultsReader& results,
                      const std::vector<long>& frames);

}  // namespace blocks::post
