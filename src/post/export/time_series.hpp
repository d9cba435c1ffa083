// Writes results at many times for other programs: a PVD collection of VTU files, or
// CSV.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "post/read/results_reader.hpp"

namespace blocks::post {

/// What was written, for the message to the user.
struct SeriesFiles {
  std::vector<std::string> names;  ///< files for the user to open
  long blocks = 0, contacts = 0;   ///< rows over all times
};

/// Writes NAME.pvd and NAME_contacts.pvd, with their VTU files in the folder NAME_vtu.
/// NAME.pvd has the blocks as polygons, with the quantities of the results file as cell
/// data. NAME_contacts.pvd has the contacts as points with place, normal, force and
/// overlap. An older folder is kept as NAME_vtu.bak. One frame is in memory at a time.
/// may_stop: called before each frame. If it throws, no file is written or renamed.
/// Throws files::FileError, also if another program is writing the series.
SeriesFiles write_pvd(const std::string& path, const ResultsReader& results,
                      const std::vector<long>& frames,
                      const std::function<void()>& may_stop);

/// Writes NAME.csv, with a row for each block and time, and NAME_contacts.csv, with a
/// row for each acting contact and time. Blocks have a column `parent` if some block
/// has split: the block from which each one split off, 0: none. Numbers are written so
/// that they can be read back exactly. may_stop: as above. Throws files::FileError.
SeriesFiles write_csv(const std::string& path, const ResultsReader& results,
                      const std::vector<long>& frames,
                      const std::function<void()>& may_stop);

}  // namespace blocks::post
