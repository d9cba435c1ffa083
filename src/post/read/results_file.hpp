// An open results file: its groups and columns (results_file.cpp), and how frames are
// read from them (results_frame.cpp, results_cracks.cpp). Only these files and
// results_reader.cpp use it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "files/hdf5_handle.hpp"
#include "output/results/results_mark.hpp"
#include "output/results/results_names.hpp"
#include "post/read/frame_units.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

using hdf5::Column;
using hdf5::Failure;
using hdf5::Handle;

/// The column of the states of laws that a run makes last.
inline constexpr const char* last_state_column = "contacts/Length";

/// The column of unbalanced forces.
inline constexpr const char* unbalanced_column = "CellData/UnbalancedForce";
/// The column of local ratios, which older results do not have.
inline constexpr const char* local_ratio_column = "CellData/LocalRatio";

/// The column of the number of cracks of each frame.
inline constexpr const char* crack_counts = "cracks/counts";

/// The file and what has been read when it was opened.
struct ResultsReader::File {
  std::string path;
  output::ChangeWatch watch;
  std::optional<std::uint64_t> opened_at;  ///< number of changes when it was opened
  Handle file, vtk, steps, own;
  std::vector<double> times;
  std::string title;
  output::ResultsNames names;
  std::optional<Units> units;
  UnitScale scale;  ///< from the units of the deck to `units`
  bool compression_positive = false;

  explicit File(const std::string& name) : path(name), watch(name) {}

  /// How long to wait for a run that is writing a frame, [s]. It needs milliseconds,
  /// but a disk may delay it.
  static constexpr std::chrono::seconds patience{10};
  static constexpr const char* busy = "a run is writing to it now; try again";

  /// Throws Failure.
  void open();
  /// Returns the result of `action`, which reads the file. If the file has changed
  /// meanwhile, opens it again and repeats, for at most `patience`. Throws Failure.
  template <class Action> auto soundly(Action&& action) -> decltype(action());

  hsize_t step_value(const std::string& name, hsize_t row) const {
    const auto value = Column::open(steps.get(), name).at<std::int64_t>(row);
    if (value < 0)
      throw Failure("Steps/" + name + " is negative");
    return static_cast<hsize_t>(value);
  }
  hsize_t count(const std::string& name, hsize_t row) const {
    const auto value = Column::open(vtk.get(), name).at<std::int64_t>(row);
    if (value < 0)
      throw Failure(name + " is negative");
    return static_cast<hsize_t>(value);
  }
  template <class T>
  std::vector<T> rows(const char* name, hsize_t row, hsize_t n) const {
    return Column::open(vtk.get(), name).read<T>(row, n);
  }
  /// Returns cell data of a frame, `width` values for each block.
  template <class T>
  std::vector<T> cells(const std::string& name, hsize_t frame, hsize_t n,
                       hsize_t width) const {
    Column column = Column::open(vtk.get(), "CellData/" + name);
    if (column.width() != width)
      throw Failure(name + " has the wrong shape");
    return column.read<T>(step_value("CellDataOffsets/" + name, frame), n);
  }
  template <class T> T field(const std::string& name, hsize_t frame) const {
    return Column::open(vtk.get(), "FieldData/" + name)
        .at<T>(step_value("FieldDataOffsets/" + name, frame));
  }
  template <class T>
  std::vector<T> contact(const char* name, hsize_t from, hsize_t n,
                         hsize_t width) const {
    Column column = Column::open(own.get(), std::string("contacts/") + name);
    if (column.width() != width)
      throw Failure(std::string("contacts/") + name + " has the wrong shape");
    return column.read<T>(from, n);
  }
  /// Returns a column of the states of laws. Rows that it lacks belong to frames
  /// before the first JOINT card and are 0.
  template <class T>
  std::vector<T> states(const char* name, hsize_t from, hsize_t n) const {
    Column column = Column::open(own.get(), std::string("contacts/") + name);
    if (column.width() != 1)
      throw Failure(std::string("contacts/") + name + " has the wrong shape");
    const hsize_t rows = column.rows(), there = rows > from ? rows - from : 0;
    std::vector<T> values = column.read<T>(std::min(from, rows), std::min(n, there));
    values.resize(n, T(0));
    return values;
  }
  /// Throws FileError, with the range of frames, unless frame i exists.
  void require(long i) const;
  Frame read(hsize_t i) const;
  FrameContacts read_contacts(hsize_t i) const;
  std::vector<LawState> read_states(hsize_t from, hsize_t m) const;
  std::vector<RecordedHistory> read_recorded() const;
  /// Returns the number of cracks up to frame i.
  hsize_t count_cracks(hsize_t i) const;
  std::vector<Crack> read_cracks() const;
  /// Returns Frame::parent of frame i with n blocks.
  std::vector<int> parents(hsize_t i, hsize_t n) const;
  /// Returns data of a frame that not every file has, `width` values for each of its
  /// rows; empty if the file has none. group: PointData or CellData.
  template <class T>
  std::vector<T> read_late(const std::string& group, const std::string& name, hsize_t i,
                           hsize_t rows, hsize_t width) const;
  std::vector<Eigen::Vector2d> read_water_line(hsize_t i) const;
  /// Adds Frame::wet_sides. places: the block and the side that begins at each point,
  /// -1: that of a removed block.
  void read_wet_sides(hsize_t i, const std::vector<std::pair<int, int>>& places,
                      Frame& frame) const;
  /// Returns the first row and the number of rows of a frame in a list of water.
  std::pair<hsize_t, hsize_t> water_rows(const char* name, hsize_t i) const;
  /// Returns the number of corners of each block in frame i.
  std::vector<std::int64_t> read_corner_counts(hsize_t i) const;
  void read_outlines(hsize_t i, hsize_t part, hsize_t n, Frame& frame) const;
};

template <class Action>
auto ResultsReader::File::soundly(Action&& action) -> decltype(action()) {
  const auto until = std::chrono::steady_clock::now() + patience;
  while (const auto number = watch.settled(until)) {
    try {
      if (opened_at != number) {
        opened_at.reset();
        open();
        opened_at = number;
      }
      auto result = action();
      if (watch.number() == *number)
        return result;
    } catch (...) {  // also std::bad_alloc, after a size read during a change
      if (watch.number() == *number)
        throw;
    }
    if (std::chrono::steady_clock::now() > until)
      break;
  }
  throw Failure(busy);
}

}  // namespace blocks::post
