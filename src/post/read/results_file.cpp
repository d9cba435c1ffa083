#include "post/read/results_file.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "files/file_error.hpp"
#include "post/read/results_nearby.hpp"

namespace blocks::post {

void ResultsReader::File::open() {
  if (const std::string fault = fault_of_head(path); !fault.empty())
    throw Failure(fault);
  for (Handle* handle : {&own, &steps, &vtk, &file})
    *handle = Handle();  // HDF5 caches data of an open file
  file = hdf5::open_file(path, false);
  if (!hdf5::exists(file.get(), "VTKHDF") || !hdf5::exists(file.get(), "BLOCKS"))
    throw Failure("it is not a results file of BLOCKS");
  vtk = hdf5::open_group(file.get(), "VTKHDF");
  steps = hdf5::open_group(vtk.get(), "Steps");
  own = hdf5::open_group(file.get(), "BLOCKS");
  if (!watch.still_named(path))
    throw Failure("another file has replaced it; try again");
  // Frames beyond NSteps are incomplete, or were cut off.
  const auto frames = hdf5::read_attribute(steps.get(), "NSteps");
  if (frames <= 0)
    throw Failure("it has no frames yet");
  if (static_cast<std::size_t>(frames) < times.size())
    throw Failure("a restart has removed frames from it; try again");
}

void ResultsReader::File::require(long i) const {
  const auto frames = static_cast<long>(times.size());
  if (i < 0 || i >= frames)
    throw files::FileError(path + " has frames 0 to " + std::to_string(frames - 1) +
                           ", not " + std::to_string(i));
}

std::vector<RecordedHistory> ResultsReader::File::read_recorded() const {
  std::vector<RecordedHistory> sections;
  const bool any = hdf5::exists(own.get(), "history");
  for (int number = 1; any; ++number) {
    const std::string place = "history/" + std::to_string(number);
    if (!hdf5::exists(own.get(), place))
      break;
    const Handle group = hdf5::open_group(own.get(), place);
    RecordedHistory section;
    section.interval = hdf5::read_real_attribute(group.get(), "interval");
    std::istringstream lines(hdf5::read_text(group.get(), "quantities"));
    for (std::string name; std::getline(lines, name);)
      section.quantities.push_back(name);
    const auto rows = hdf5::read_attribute(group.get(), "rows");
    Column time = Column::open(group.get(), "time"),
           values = Column::open(group.get(), "values");
    if (rows < 0 || time.width() != 1 || values.width() != section.quantities.size())
      throw Failure(place + " has the wrong shape");
    const auto count = static_cast<hsize_t>(rows);
    section.time = time.read<double>(0, count);
    if (!std::all_of(section.time.begin(), section.time.end(),
                     [](double t) { return std::isfinite(t); }))
      throw Failure(place + "/time is not finite");
    const std::vector<double> stored = values.read<double>(0, count);
    section.values = Eigen::Map<const Eigen::MatrixXd>(
        stored.data(), static_cast<Eigen::Index>(values.width()), rows);
    if (count > 0)
      sections.push_back(std::move(section));
  }
  return sections;
}

}  // namespace blocks::post
